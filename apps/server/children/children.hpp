#pragma once
/// What the server's own children do: `spectralpack-server --child NAME ...`, each a process of its own. They run in a
/// job's folder (jobs/job_folder.hpp) and leave their results there.

#include <string>
#include <vector>

namespace spectralpack::server {

/// Runs one and returns its exit status: 0 done, 3 a file cannot be used, 4 no room. Messages go to standard error.
int run_child(const std::vector<std::string>& arguments);

/// run PROGRAM TIME_LIMIT BEFORE: packs the job, checks what came of it, draws a picture. It outlives the server.
/// BEFORE is the packing that it had, of which run/how.json may let something stay; empty: none.
int pack_job(const std::vector<std::string>& arguments);
/// judge PROGRAM WHAT: the second half of it. WHAT "plan": a packing that has no plan gets one before.
int judge_packing(const std::vector<std::string>& arguments);
/// read NUMBER NAME ...: what is in files of the job, to previews/. A mesh's id is 1000 times its file's number, and
/// which it is in the file.
int read_files(const std::vector<std::string>& arguments);
/// export FROM TO TRAY: a packing as another file; TRAY from 1, 0: all.
int export_packing(const std::vector<std::string>& arguments);
/// clearance FILE: how near a copy stands to others and to the walls, as JSON. FILE: as AskedClearance of openapi.json,
/// or the tray and the position of its placement.
int print_clearance(const std::vector<std::string>& arguments);
/// change FILE TO: the packing after the Changes in FILE.
int change_packing(const std::vector<std::string>& arguments);
/// import PACKING: makes the folder a job whose result is this packing.
int import_packing(const std::vector<std::string>& arguments);

}  // namespace spectralpack::server
