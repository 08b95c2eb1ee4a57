// gridscope info: the Vulkan devices, what each can and can't do for us, and whether it computes the same bits as C++.
#include "app/base/progress.h"
#include "app/base/text.h"
#include "app/commands/commands.h"
#include "app/report/report.h"
#include "core/base/error.h"
#include "core/base/version.h"
#include "core/checks/self_test.h"

namespace gridscope {

namespace {

using Json = nlohmann::ordered_json;

// A device's self-test, or why there is none.
struct TestedDevice {
  DeviceReport report;
  SelfTestResult test;
  std::string failure;  // why it could not run; empty: it ran

  bool passed() const { return failure.empty() && test.passed(); }
};

TestedDevice testDevice(const DeviceReport& report, size_t index, bool validation) {
  TestedDevice device{.report = report, .test = {}, .failure = report.refusal};
  if (!device.failure.empty()) return device;
  try {
    GpuContext gpu({.device = std::to_string(index), .validation = validation});
    device.test = runSelfTest(gpu);
    if (gpu.validationMessages() > 0) device.failure = printed("%u validation messages", gpu.validationMessages());
  } catch (const Error& error) {
    device.failure = error.what();
  }
  return device;
}

uint64_t largestGridBytes(const DeviceReport& report) {
  return std::min({report.maxImageBytes, report.maxAllocationBytes, report.deviceMemoryBytes});
}

std::string testText(const TestedDevice& device) {
  if (!device.failure.empty()) return "not passed: " + device.failure;
  uint64_t cases = 0, different = 0;
  std::vector<std::string> wrong;
  for (const SelfTestResult::Item& item : device.test.items) {
    cases += item.cases;
    different += item.different;
    if (item.different > 0) wrong.push_back(item.name);
  }
  if (wrong.empty())
    return printed("passed: %zu operations and stages, %s cases, the same bits as C++", device.test.items.size(), grouped(cases).c_str());
  return printed("failed: %s of %s words differ from C++, in %s", grouped(different).c_str(), grouped(cases).c_str(),
                 joined(wrong, ", ").c_str());
}

void printDevice(std::FILE* out, const TestedDevice& device, size_t index) {
  const DeviceReport& report = device.report;
  auto yesNo = [](bool yes, const char* without) { return yes ? std::string("yes") : std::string("no: ") + without; };
  std::fprintf(out, "%zu  %s\n", index, report.name.c_str());
  Table table("ll");
  table.add({"   driver", report.driver + ", Vulkan " + report.apiVersionText + (report.softwareDevice ? ", on the CPU's cores" : "")});
  table.add({"   can be used", yesNo(report.refusal.empty(), report.refusal.c_str())});
  table.add({"   geometry stage", yesNo(report.geometryStage, "--builder compute only")});
  table.add({"   image atomics", yesNo(report.imageAtomics, "required")});
  table.add({"   64-bit floats", yesNo(report.float64, "required for the same bits as elsewhere")});
  table.add({"   scalar layout", yesNo(report.scalarLayout, "required")});
  table.add({"   largest grid", printed("%u texels a side, ", report.maxImageSide) + byteText(largestGridBytes(report))});
  table.add({"   largest frame", grouped(report.maxStorageBufferBytes / sizeof(GatherPixel)) + " pixels"});
  table.add({"   descriptor indexing", yesNo(report.descriptorIndexing, "diffuse maps are layers of one image")});
  table.add({"   rounding control", yesNo(report.roundingControl, "the self-test says whether it is needed")});
  table.add({"   timestamps", yesNo(report.timestamps, "times are the host's")});
  table.add({"   self-test", testText(device)});
  table.print(out);
}

Json deviceJson(const TestedDevice& device, size_t index) {
  const DeviceReport& report = device.report;
  Json items = Json::array();
  for (const SelfTestResult::Item& item : device.test.items)
    items.push_back({{"name", item.name}, {"cases", item.cases}, {"different", item.different}});
  return {{"index", index},
          {"device", report.name},
          {"driver", report.driver},
          {"vulkan", report.apiVersionText},
          {"software", report.softwareDevice},
          {"refusal", report.refusal},
          {"geometryStage", report.geometryStage},
          {"imageAtomics", report.imageAtomics},
          {"float64", report.float64},
          {"scalarLayout", report.scalarLayout},
          {"descriptorIndexing", report.descriptorIndexing},
          {"roundingControl", report.roundingControl},
          {"timestamps", report.timestamps},
          {"largestGrid", {{"side", report.maxImageSide}, {"bytes", largestGridBytes(report)}}},
          {"largestFramePixels", report.maxStorageBufferBytes / sizeof(GatherPixel)},
          {"selfTest", {{"passed", device.passed()}, {"failure", device.failure}, {"items", items}}}};
}

}  // namespace

void addInfoOptions(CLI::App& command, Options& options) {
  addValidationOption(command, options);
  addJsonOption(command, options);
}

int runInfo(const Options& options) {
  const std::vector<DeviceReport> reports = listDevices();
  Progress progress(reports.size());
  Json devices = Json::array();
  size_t usable = 0, failed = 0;
  for (size_t index = 0; index < reports.size(); ++index) {
    progress.step("self-test of " + reports[index].name);
    const TestedDevice device = testDevice(reports[index], index, options.validation);
    progress.clear();
    printDevice(textStream(options), device, index);
    devices.push_back(deviceJson(device, index));
    usable += device.report.refusal.empty() ? 1 : 0;
    failed += device.report.refusal.empty() && !device.passed() ? 1 : 0;
  }
  writeJson(options, {{"version", kVersion}, {"devices", devices}});
  if (usable == 0)
    throw Error(reports.empty() ? "no Vulkan device was found; install a driver (mesa-vulkan-drivers brings one for the CPU)"
                                : "no Vulkan device can be used; the list says why",
                kExitDevice);
  return failed > 0 ? kExitDifferent : kExitDone;
}

}  // namespace gridscope
