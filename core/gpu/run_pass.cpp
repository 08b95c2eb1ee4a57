// See run_pass.h.
#include "core/gpu/run_pass.h"

#include "core/gpu/program.h"

namespace gridscope {

std::vector<std::byte> runPass(GpuContext& gpu, const PassRun& run) {
  GpuPrograms programs(gpu.device());
  uploadBytes(gpu.device(), programs.bound().makeBuffer(run.inputBinding, run.stem + " input", run.input.size()), run.input);
  const GpuBuffer& output = programs.bound().makeBuffer(run.outputBinding, run.stem + " results", run.outputBytes);
  GpuCommands commands(gpu.device());
  programs.dispatch(commands, run.stem, {int(run.invocations), 1, 1});
  commands.run();
  std::vector<std::byte> results(run.outputBytes);
  downloadBytes(gpu.device(), output, results);
  return results;
}

}  // namespace gridscope
