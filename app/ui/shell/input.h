// From GLFW's events to ImGui's input. Events are queued and one key or button event is fed a frame: what is pressed and released between
// two frames is still seen, with the modifiers that it had.
#pragma once

#include <deque>
#include <string>
#include <vector>

struct GLFWwindow;

namespace gridscope {

// A pressed key: an upper-case letter or sign as the keyboard's layout has it ('N', '[', '?'), else GLFW's code.
struct KeyPress {
  int key = 0;
  bool control = false;
  bool alt = false;
  bool shift = false;
};

class WindowInput {
 public:
  explicit WindowInput(GLFWwindow* window);  // installs the callbacks; the window's user pointer is this

  // Hands ImGui the input of its next frame; returns the keys pressed in it.
  std::vector<KeyPress> feed(float width, float height, double secondsSinceLast);

  bool waiting() const { return !events_.empty(); }
  bool takeActivity();  // was there any event since the last call?
  std::vector<std::string> takeDroppedFiles();

 private:
  struct Event {
    enum Kind { key, character, button, wheel, move, leave } kind;
    int code = 0;
    bool down = false;
    bool repeated = false;
    int modifiers = 0;
    float x = 0.0f, y = 0.0f;
  };
  void push(const Event& event);
  void feedKey(const Event& event, std::vector<KeyPress>& pressed);

  GLFWwindow* window_;
  std::deque<Event> events_;
  std::vector<std::string> dropped_;
  bool activity_ = true;
};

}  // namespace gridscope
