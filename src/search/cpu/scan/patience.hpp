#pragma once
/// When to ask what is often in vain.

#include <algorithm>

#include "search/cpu/tuning.hpp"

namespace spectralpack {

/// What may be asked first and often says nothing, as cells do in a crowd and stacks in the open: where asking was
/// in vain more than `patience` times, it is not asked as many times again.
class Patience {
  public:
    explicit Patience(int patience = 0) : patience_(patience) {}
    bool asks() {
        if (skip_ == 0) return true;
        --skip_;
        return false;
    }
    void learn(bool in_vain) {
        vain_ = in_vain ? std::min(vain_ + 1, tuning::kMostLeftOut) : -patience_;
        skip_ = std::max(0, vain_);
    }

  private:
    int patience_;
    int vain_ = -patience_, skip_ = 0;
};

}  // namespace spectralpack
