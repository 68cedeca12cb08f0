#pragma once
/// Who is told what happens in the trays of a packing, as it happens.

#include <vector>

#include "packing/tray/placed_copy.hpp"

namespace spectralpack {

/// All that is told from tray_begun() to tray_finished() is of that tray. Who applies the calls in order holds what the
/// packing holds: the copies of each tray, in whatever order. A tray may begin anew: what was told of it before is
/// void. One that is told of and stays without copies may not be among the trays of the result. Strategies that pack
/// more than once tell of the packing that is kept. Exceptions that leave an observer end the packing.
class TrayObserver {
  public:
    virtual ~TrayObserver() = default;
    /// Tray `number`, from 0, holds its fixed copies and nothing else.
    virtual void tray_begun(int number) = 0;
    /// Where it really stands, refined or not.
    virtual void copy_placed(const PlacedCopy& placed) = 0;
    /// It stands elsewhere now, as told.
    virtual void copy_moved(const PlacedCopy& placed) = 0;
    /// It stands nowhere any more; as it was told of before.
    virtual void copy_taken_out(const PlacedCopy& placed) = 0;
    /// One that was taken out stands again, perhaps elsewhere.
    virtual void copy_put_back(const PlacedCopy& placed) = 0;
    virtual void tray_finished() = 0;
};

/// The tray begins anew with these copies; it is not finished.
inline void tell_anew(TrayObserver& observer, int number, const std::vector<PlacedCopy>& placed) {
    observer.tray_begun(number);
    for (const PlacedCopy& copy : placed) {
        observer.copy_placed(copy);
    }
}

}  // namespace spectralpack
