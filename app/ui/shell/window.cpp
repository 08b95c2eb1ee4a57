// See window.h. One loop: events, the worker's news, the interface, its picture.
#include "app/ui/shell/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_vulkan.h>
#include <vulkan/vulkan.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <utility>

#include "app/model/flow.h"
#include "app/model/preferences.h"
#include "app/ui/shell/images.h"
#include "app/ui/shell/input.h"
#include "app/ui/shell/layout.h"
#include "app/ui/shell/log.h"
#include "app/ui/shell/run_key.h"
#include "app/ui/widgets/theme.h"
#include "app/worker/worker.h"
#include "core/base/error.h"

namespace gridscope {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kIdleSeconds = 0.5;         // between two looks when nothing happens
constexpr double kBusySeconds = 1.0 / 30.0;  // between two frames while something moves
constexpr int kFramesAfterEvent = 3;         // ImGui needs a few frames to settle

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

void onGlfwError(int, const char* text) { std::fprintf(stderr, "GLFW: %s\n", text); }

// GLFW's window, and its end.
class NativeWindow {
 public:
  NativeWindow(uint32_t width, uint32_t height) {
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    handle_ = glfwCreateWindow(int(width), int(height), "Gridscope", nullptr, nullptr);
    if (!handle_) {
      glfwTerminate();
      throw Error("the window can't be opened; render with: gridscope render SCENE", kExitDevice);
    }
    glfwSetWindowSizeLimits(handle_, 640, 400, GLFW_DONT_CARE, GLFW_DONT_CARE);
  }
  ~NativeWindow() {
    glfwDestroyWindow(handle_);
    glfwTerminate();
  }
  NativeWindow(const NativeWindow&) = delete;
  NativeWindow& operator=(const NativeWindow&) = delete;
  GLFWwindow* handle() const { return handle_; }
  VkExtent2D size() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(handle_, &width, &height);
    return {uint32_t(width), uint32_t(height)};
  }

 private:
  GLFWwindow* handle_ = nullptr;
};

// ImGui's context, and its Vulkan backend, which is made anew with the fonts when the scale changes.
class Interface {
 public:
  Interface() {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().ConfigWindowsMoveFromTitleBarOnly = true;
  }
  ~Interface() {
    closeBackend();
    ImGui::DestroyContext();
  }
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

  void openBackend(const WindowDevice& device, const WindowSwapchain& swapchain) {
    device_ = &device;
    const WindowVulkan& vk = device.vulkan();
    VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 4};
    VkDescriptorPoolCreateInfo pool{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    pool.flags = VK_DESCRIPTOR_POOL_CREATE_FREE_DESCRIPTOR_SET_BIT;
    pool.maxSets = 4;
    pool.poolSizeCount = 1;
    pool.pPoolSizes = &size;
    VK_CHECK(vk.CreateDescriptorPool(device.device(), &pool, nullptr, &pool_));
    auto find = [](const char* name, void* user) {
      const WindowDevice& owner = *static_cast<const WindowDevice*>(user);
      return owner.vulkan().GetInstanceProcAddr(owner.instance(), name);
    };
    ImGui_ImplVulkan_LoadFunctions(find, const_cast<WindowDevice*>(&device));
    ImGui_ImplVulkan_InitInfo info{};
    info.Instance = device.instance();
    info.PhysicalDevice = device.physicalDevice();
    info.Device = device.device();
    info.QueueFamily = device.queueFamily();
    info.Queue = device.queue();
    info.DescriptorPool = pool_;
    info.MinImageCount = info.ImageCount = 3;  // buffers in turn: more than frames in flight
    info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
    info.CheckVkResultFn = [](VkResult result) { checkVulkan(result, "ImGui's Vulkan backend"); };
    ImGui_ImplVulkan_Init(&info, swapchain.renderPass());
    uploadFonts();
  }

  void closeBackend() {
    if (!device_) return;
    device_->waitIdle();
    ImGui_ImplVulkan_Shutdown();
    device_->vulkan().DestroyDescriptorPool(device_->device(), pool_, nullptr);
    device_ = nullptr;
  }

 private:
  void uploadFonts() {
    const WindowVulkan& vk = device_->vulkan();
    VkCommandPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    poolInfo.queueFamilyIndex = device_->queueFamily();
    VkCommandPool pool = VK_NULL_HANDLE;
    VK_CHECK(vk.CreateCommandPool(device_->device(), &poolInfo, nullptr, &pool));
    VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    allocate.commandPool = pool;
    allocate.commandBufferCount = 1;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    VK_CHECK(vk.AllocateCommandBuffers(device_->device(), &allocate, &commands));
    VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO, nullptr, VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
    VK_CHECK(vk.BeginCommandBuffer(commands, &begin));
    ImGui_ImplVulkan_CreateFontsTexture(commands);
    VK_CHECK(vk.EndCommandBuffer(commands));
    VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO};
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands;
    VK_CHECK(vk.QueueSubmit(device_->queue(), 1, &submit, VK_NULL_HANDLE));
    device_->waitIdle();
    ImGui_ImplVulkan_DestroyFontUploadObjects();
    vk.DestroyCommandPool(device_->device(), pool, nullptr);
  }

  const WindowDevice* device_ = nullptr;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
};

void showCursor(GLFWwindow* window) {
  static GLFWcursor* cursors[ImGuiMouseCursor_COUNT] = {};
  static int shown = -2;
  const int wanted = ImGui::GetMouseCursor();
  if (wanted == shown || wanted == ImGuiMouseCursor_None) return;
  const int shapes[ImGuiMouseCursor_COUNT] = {GLFW_ARROW_CURSOR,   GLFW_IBEAM_CURSOR,   GLFW_ARROW_CURSOR,
                                              GLFW_VRESIZE_CURSOR, GLFW_HRESIZE_CURSOR, GLFW_ARROW_CURSOR,
                                              GLFW_ARROW_CURSOR,   GLFW_HAND_CURSOR,    GLFW_ARROW_CURSOR};
  if (!cursors[wanted]) cursors[wanted] = glfwCreateStandardCursor(shapes[wanted]);
  glfwSetCursor(window, cursors[wanted]);
  shown = wanted;
}

// Everything of a running window.
class Window {
 public:
  Window(const Options& start, const WindowOptions& options)
      : native_(options.width, options.height),
        device_(native_.handle(), start.validation),
        swapchain_(device_),
        images_(device_, swapchain_.renderPass()),
        input_(native_.handle()),
        worker_(start, [] { glfwPostEmptyEvent(); }) {
    windowImages() = &images_;
    model_.logToStandardError = options.logToStandardError;
    model_.request.source = sourceOf(start);
    model_.request.timeSeconds = start.time;
    model_.request.slice = start.slice;
    model_.timeStep = start.frameStep;
    model_.startDevice = start.device;
    readPreferences(model_);
    preferences_.emplace(model_);
    showIn(model_, Workspace::grid);
    dress();
    worker_.ask(sent_ = wantedRequest());
  }

  int run() {
    while (!model_.quit) {
      waitForEvents();
      const Clock::time_point start = Clock::now();
      if (glfwWindowShouldClose(native_.handle())) model_.quit = true;
      takeNews();
      const bool drawn = wantsFrame() && drawFrame();
      sendWishes();
      if (drawn) frameMs_.push_back(float(1000.0 * secondsSince(start)));
      preferences_->look(model_);
    }
    preferences_->end(model_);
    sayFrameTimes();
    worker_.end();
    return kExitDone;
  }

  uint32_t validationMessages() const { return device_.validationMessages() + worker_.validationMessages(); }

 private:
  // Fonts and colours of the present theme and scale.
  void dress() {
    device_.waitIdle();
    interface_.closeBackend();
    loadWindowFonts(model_.uiScale);
    applyTheme(model_.theme, model_.uiScale);
    interface_.openBackend(device_, swapchain_);
    dressedScale_ = model_.uiScale;
    dressedTheme_ = model_.theme;
  }

  bool moving() const {
    return model_.playing || model_.stepsPlaying || model_.flying || model_.work || model_.files.running() ||
           model_.report.state().running || model_.now < model_.toastUntil || ImGui::IsAnyMouseDown();
  }

  void waitForEvents() {
    if (input_.waiting() || settle_ > 0)
      glfwPollEvents();
    else
      glfwWaitEventsTimeout(moving() ? kBusySeconds : kIdleSeconds);
    if (input_.takeActivity()) settle_ = kFramesAfterEvent;
  }

  void takeNews() {
    model_.now = secondsSince(began_);
    for (LogLine& line : worker_.takeLines()) {
      if (line.shown)
        model_.announce(line.kind, std::move(line.text));
      else
        model_.say(line.kind, std::move(line.text));
      settle_ = std::max(settle_, 1);
    }
    for (FileJobs::News& news : model_.files.takeNews()) {
      model_.announce(news.failed ? LogLine::Kind::error : LogLine::Kind::note, std::move(news.text));
      settle_ = kFramesAfterEvent;
    }
    if (std::optional<FileJobs::News> news = model_.report.takeNews()) {
      model_.announce(news->failed ? LogLine::Kind::error : LogLine::Kind::note, std::move(news->text));
      model_.reportDialogOpen = false;
      settle_ = kFramesAfterEvent;
    }
    const std::string deviceFault = worker_.deviceFault();
    if (!deviceFault.empty()) throw Error(deviceFault, kExitDevice);
    model_.shaderFault = worker_.shaderFault();
    const bool worked = model_.work.has_value();
    model_.work = worker_.work();
    if (worked != model_.work.has_value()) settle_ = kFramesAfterEvent;
    std::shared_ptr<const FrameSnapshot> frame = worker_.newest();
    if (frame == model_.frame || !frame) return;
    if (!frame->scene && !frame->fault.empty()) throw Error(frame->fault);  // the first source can't be loaded
    settle_ = std::max(settle_, 2);
    if (!model_.frame || model_.frame->views != frame->views) ++pictures_;
    takeFrame(model_, std::move(frame));
  }

  bool wantsFrame() {
    if (input_.waiting() || moving()) return true;
    // Slow changes, a blinking cursor say, are seen twice a second.
    if (settle_ > 0 || secondsSince(lastFrame_) >= kIdleSeconds) return true;
    return false;
  }

  // False: there is nothing to draw on.
  bool drawFrame() {
    const VkExtent2D size = native_.size();
    if (size.width == 0 || size.height == 0) return false;
    if (model_.uiScale != dressedScale_)
      dress();
    else if (model_.theme != dressedTheme_)
      applyTheme(dressedTheme_ = model_.theme, model_.uiScale);

    const Clock::time_point start = Clock::now();
    const double sinceLast = std::min(secondsSince(lastFrame_), 0.25);
    lastFrame_ = start;
    if (settle_ > 0) --settle_;
    images_.beginFrame();
    const std::vector<KeyPress> pressed = input_.feed(float(size.width), float(size.height), sinceLast);
    for (const std::string& file : input_.takeDroppedFiles()) openSource(model_, file);
    ImGui_ImplVulkan_NewFrame();
    ImGui::NewFrame();
    for (const KeyPress& key : pressed) runKey(model_, key);
    advanceModel(model_);
    drawLayout(model_, float(size.width), float(size.height));
    if (model_.clipboardWish) ImGui::SetClipboardText(std::exchange(model_.clipboardWish, std::nullopt)->c_str());
    logChanges(model_, logged_);
    ImGui::Render();
    showCursor(native_.handle());

    const ImVec4 back = uiColour(UiColour::window);
    swapchain_.draw(
        size, {{back.x, back.y, back.z, 1.0f}}, [&](VkCommandBuffer commands) { images_.upload(commands, swapchain_.frame()); },
        [&](VkCommandBuffer commands) {
          images_.beginDrawing(commands, swapchain_.extent());
          ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), commands);
        });
    model_.interfaceMs = 1000.0 * secondsSince(start);
    return true;
  }

  FrameRequest wantedRequest() { return requestOf(model_); }

  // What the model asks of the world outside the interface.
  void sendWishes() {
    if (model_.cancelWork) worker_.cancel();
    model_.cancelWork = false;
    FrameRequest wanted = wantedRequest();
    if (!sameRequest(wanted, sent_)) worker_.ask(sent_ = std::move(wanted));
    if (model_.captureWish) worker_.capture(*model_.captureWish);
    model_.captureWish.reset();
    const std::string title = windowTitle(model_);
    if (title != title_) glfwSetWindowTitle(native_.handle(), (title_ = title).c_str());
  }

  void sayFrameTimes() {
    if (frameMs_.empty()) return;
    std::ranges::sort(frameMs_);
    std::fprintf(stderr, "Interface frames: %zu, median %.1f ms, p99 %.1f ms, longest %.1f ms; pictures: %u\n", frameMs_.size(),
                 double(frameMs_[frameMs_.size() / 2]), double(frameMs_[size_t(double(frameMs_.size() - 1) * 0.99)]),
                 double(frameMs_.back()), pictures_);
  }

  NativeWindow native_;
  WindowDevice device_;
  WindowSwapchain swapchain_;
  DeviceImages images_;
  Interface interface_;
  WindowInput input_;
  FrameWorker worker_;
  WindowModel model_;
  LoggedState logged_;
  FrameRequest sent_;
  std::string title_;
  float dressedScale_ = 0.0f;
  Theme dressedTheme_ = Theme::dark;
  Clock::time_point began_ = Clock::now(), lastFrame_ = began_;
  int settle_ = kFramesAfterEvent;
  std::optional<PreferenceKeeper> preferences_;  // from what was read on
  std::vector<float> frameMs_;                   // of each frame of the interface, all that lies between two waits for events
  uint32_t pictures_ = 0;                        // snapshots with other views than the one before
};

}  // namespace

std::string whyNoWindow() {
  if (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY")) return "there is no display";
  glfwSetErrorCallback(nullptr);
  if (!glfwInit()) return "the display can't be opened";
  return WindowDevice::whyNone();
}

int runWindow(const Options& start, const WindowOptions& options) {
  const std::string why = whyNoWindow();
  if (!why.empty()) throw Error("no window: " + why + "; render with: gridscope render " + start.scene + " --view all", kExitDevice);
  glfwSetErrorCallback(onGlfwError);
  uint32_t messages = 0;
  int exitCode = kExitDone;
  {
    Window window(start, options);
    exitCode = window.run();
    messages = window.validationMessages();
  }
  if (start.validation) std::fprintf(stderr, "validation: %u messages\n", messages);
  if (messages > 0) exitCode = kExitDifferent;
  if (loadsUnderWay() > 0) {
    // A load that was left alone still runs: what it uses must not be taken down under it.
    std::fflush(nullptr);
    std::_Exit(exitCode);
  }
  return exitCode;
}

}  // namespace gridscope
