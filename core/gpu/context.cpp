// See context.h.
#include "core/gpu/context.h"

#include "core/gpu/device.h"

namespace gridscope {
namespace {

std::unique_ptr<GpuDevice> makeDevice(const GpuInstance& instance, const std::string& wanted) {
  std::vector<VkPhysicalDevice> devices = instance.physicalDevices();
  std::vector<DeviceReport> reports;
  for (VkPhysicalDevice device : devices) reports.push_back(reportDevice(device));
  size_t chosen = chooseDevice(reports, wanted);

  DeviceFeatures features;
  features.core.features.shaderFloat64 = VK_TRUE;
  features.core.features.fragmentStoresAndAtomics = VK_TRUE;
  features.core.features.geometryShader = reports[chosen].geometryStage;
  features.core.features.vertexPipelineStoresAndAtomics = reports[chosen].geometryStage;
  features.v12.scalarBlockLayout = VK_TRUE;
  features.v13.dynamicRendering = VK_TRUE;
  features.v13.synchronization2 = VK_TRUE;
  GpuDevice::Request request{
      .physicalDevice = devices[chosen], .queueFamily = uint32_t(graphicsQueueFamily(devices[chosen])), .features = &features.core};
  return std::make_unique<GpuDevice>(instance, request);
}

}  // namespace

std::vector<DeviceReport> listDevices() {
  if (!loadVulkan()) return {};
  std::vector<DeviceReport> reports;
  try {
    const GpuInstance instance({});
    for (VkPhysicalDevice device : instance.physicalDevices()) reports.push_back(reportDevice(device));
  } catch (const Error&) {
    return {};  // a loader without a driver
  }
  return reports;
}

GpuContext::GpuContext(const GpuOptions& options)
    : instance_(std::make_unique<GpuInstance>(GpuInstance::Request{.validation = options.validation})),
      device_(makeDevice(*instance_, options.device)) {}

GpuContext::~GpuContext() = default;

const DeviceReport& GpuContext::report() const { return device_->report(); }
bool GpuContext::validated() const { return instance_->validated(); }
uint32_t GpuContext::validationMessages() const { return instance_->validationMessages(); }

}  // namespace gridscope
