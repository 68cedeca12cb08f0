# Writes OUT, the source that says which commit SOURCE_DIR is at; left as it is where it says so already.
execute_process(COMMAND git -C ${SOURCE_DIR} describe --always --dirty=-changed
                OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
    set(commit unknown)
endif()
file(CONFIGURE OUTPUT ${OUT} CONTENT [[#include "tools/bench/commit.hpp"

namespace spectralpack::tools {

const char* const kCommit = "@commit@";

}  // namespace spectralpack::tools
]] @ONLY)
