// A Vulkan device that frames are made on: which there are, choosing one, what it can and can't do for us. What Vulkan calls it by is in
// device.h, for this folder alone.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/gpu/pass_limits.h"

namespace gridscope {

class GpuDevice;
class GpuInstance;

// What a device can do for us.
struct DeviceReport {
  std::string name;
  std::string driver;               // name and version
  uint32_t apiVersion = 0;          // packed
  std::string apiVersionText;       // "1.3.230"
  bool softwareDevice = false;      // runs on the CPU's cores (lavapipe)
  bool geometryStage = false;       // geometry shaders with stores: the raster builder
  bool imageAtomics = false;        // 3D r32ui storage image with atomics: required
  bool float64 = false;             // required for the same bits as everywhere
  bool scalarLayout = false;        // required
  bool descriptorIndexing = false;  // variable-count descriptor sets
  bool roundingControl = false;     // round to nearest even and signed zeros can be asked for
  bool timestamps = false;
  uint32_t maxImageSide = 0;   // texels of a 3D image
  uint64_t maxImageBytes = 0;  // of one r32ui 3D image
  uint64_t maxAllocationBytes = 0;
  uint64_t maxStorageBufferBytes = 0;
  uint64_t deviceMemoryBytes = 0;  // largest device-local heap
  uint32_t maxImageArrayLayers = 0;
  uint32_t maxImage2DSide = 0;
  PassLimits passLimits;
  std::string refusal;  // why it can't be used; empty: it can
};

struct GpuOptions {
  std::string device;       // name (part of it, any case) or index; empty: the first that can be used, GPUs before software
  bool validation = false;  // core and synchronization validation; messages are counted and printed
};

// All Vulkan devices of this machine, in the loader's order. Empty when there is no Vulkan loader or no driver.
std::vector<DeviceReport> listDevices();

// Validation messages of the whole process, also of devices that are gone: what outlives its device is told as that ends.
uint32_t allValidationMessages();

class GpuContext {
 public:
  // Throws Error: kExitBadInput for an unknown name, kExitDevice when no device can be used.
  explicit GpuContext(const GpuOptions& options);
  ~GpuContext();
  GpuContext(const GpuContext&) = delete;
  GpuContext& operator=(const GpuContext&) = delete;

  const DeviceReport& report() const;
  bool validated() const;
  uint32_t validationMessages() const;
  GpuDevice& device() { return *device_; }

 private:
  std::unique_ptr<GpuInstance> instance_;
  std::unique_ptr<GpuDevice> device_;
};

}  // namespace gridscope
