#include "engines.hpp"

#ifdef SPECTRALPACK_TEST_CPU
#include "search/cpu/cpu_search.hpp"
#endif
#ifdef SPECTRALPACK_TEST_REFERENCE
#include "search/reference/reference_search.hpp"
#endif

namespace spectralpack::test {

std::vector<EngineFactory> engines() {
    std::vector<EngineFactory> all;
#ifdef SPECTRALPACK_TEST_REFERENCE
    all.push_back({"reference", [](const Workers& workers) { return make_reference_search({}, workers); }});
#endif
#ifdef SPECTRALPACK_TEST_CPU
    all.push_back({"cpu", [](const Workers& workers) { return make_cpu_search({}, workers); }});
    all.push_back({"cpu_with_crowd_tables", [](const Workers& workers) {
                       CpuOptions options;
                       options.large_from = 0;
                       options.bytes = false;
                       return make_cpu_search(options, workers);
                   }});
#endif
    return all;
}

}  // namespace spectralpack::test
