#pragma once
/// Sizes that cannot wrap: every product that becomes an allocation goes through here.

#include <cstdint>
#include <initializer_list>

#include "spectralpack/error.hpp"

namespace spectralpack {

/// Product of non-negative factors. Throws ResourceError when it does not fit 63 bits.
inline std::int64_t checked_product(std::initializer_list<std::int64_t> factors) {
    std::int64_t product = 1;
    for (const std::int64_t factor : factors) {
        if (factor < 0 || __builtin_mul_overflow(product, factor, &product)) {
            throw ResourceError("a size is beyond what this machine can address");
        }
    }
    return product;
}

}  // namespace spectralpack
