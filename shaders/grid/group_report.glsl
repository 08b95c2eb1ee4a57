// Adds a workgroup's reports up before they reach memory: one atomic a word and workgroup. Every invocation of the workgroup must call it.
shared BuildReport groupReport;

void addGroupReport(BuildReport report) {
  if (gl_LocalInvocationIndex == 0u) groupReport = emptyReport();
  barrier();
  atomicAdd(groupReport.tried, report.tried);
  atomicAdd(groupReport.stored, report.stored);
  atomicAdd(groupReport.refused, report.refused);
  atomicAdd(groupReport.outside, report.outside);
  atomicAdd(groupReport.degenerate, report.degenerate);
  atomicAdd(groupReport.cellsExpected, report.cellsExpected);
  atomicAdd(groupReport.cellsWalked, report.cellsWalked);
  atomicAdd(groupReport.loopsCut, report.loopsCut);
  barrier();
  if (gl_LocalInvocationIndex == 0u) addReport(groupReport);
}
