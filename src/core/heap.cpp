#include "core/heap.hpp"

#include <cstdlib>  // defines __GLIBC__

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace spectralpack {

void give_back_freed() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

}  // namespace spectralpack
