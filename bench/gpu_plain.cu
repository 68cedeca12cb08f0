#include <cuda_runtime.h>
#include <cufft.h>

#include <algorithm>
#include <cfloat>
#include <map>
#include <stdexcept>
#include <string>

#include "gpu_plain.hpp"

namespace {

void check(cudaError_t status) {
    if (status != cudaSuccess) throw std::runtime_error(std::string("GPU: ") + cudaGetErrorString(status));
}
void check(cufftResult status) {
    if (status != CUFFT_SUCCESS) throw std::runtime_error("cuFFT: error " + std::to_string(static_cast<int>(status)));
}

template <class T>
class DeviceArray {
  public:
    DeviceArray() = default;
    ~DeviceArray() { cudaFree(data_); }
    DeviceArray(const DeviceArray&) = delete;
    DeviceArray& operator=(const DeviceArray&) = delete;

    void grow(std::size_t count) {
        if (count <= count_) return;
        cudaFree(data_);
        data_ = nullptr;
        check(cudaMalloc(&data_, count * sizeof(T)));
        count_ = count;
    }
    void put(const T* values, std::size_t count) {
        grow(count);
        check(cudaMemcpy(data_, values, count * sizeof(T), cudaMemcpyHostToDevice));
    }
    T* data() const { return data_; }
    std::size_t bytes() const { return count_ * sizeof(T); }

  private:
    T* data_ = nullptr;
    std::size_t count_ = 0;
};

/// Where a grid's bits lie among the words that were sent, and where they go.
struct Placed {
    std::int64_t first;  ///< word
    int words_per_row, extent[3], offset[3], lane;
};
struct Candidates {
    int count[3];
};
/// A transform's grid; rows are padded so that spectra lie in place.
struct Grid {
    int n[3];
    std::int64_t row, lane;  ///< floats
};

__device__ int wrapped(int i, int n) { return ((i % n) + n) % n; }

/// One thread a word; blockIdx.y is the grid.
__global__ void put_bits(const std::uint64_t* words, const Placed* all, Grid grid, float* lanes) {
    const Placed placed = all[blockIdx.y];
    const std::int64_t i = blockIdx.x * static_cast<std::int64_t>(blockDim.x) + threadIdx.x;
    const std::int64_t rows = static_cast<std::int64_t>(placed.extent[1]) * placed.extent[2];
    if (i >= rows * placed.words_per_row) return;
    std::uint64_t word = words[placed.first + i];
    const std::int64_t row = i / placed.words_per_row;
    const int x = 64 * static_cast<int>(i % placed.words_per_row);
    const int y = wrapped(static_cast<int>(row % placed.extent[1]) + placed.offset[1], grid.n[1]);
    const int z = wrapped(static_cast<int>(row / placed.extent[1]) + placed.offset[2], grid.n[2]);
    float* to = lanes + placed.lane * grid.lane + (static_cast<std::int64_t>(z) * grid.n[1] + y) * grid.row;
    for (; word != 0; word &= word - 1) {
        to[wrapped(x + __ffsll(static_cast<long long>(word)) - 1 + placed.offset[0], grid.n[0])] = 1;
    }
}

__global__ void put_phi(const std::int32_t* phi, int nx, int ny, int nz, Grid grid, float* lane) {
    const std::int64_t i = blockIdx.x * static_cast<std::int64_t>(blockDim.x) + threadIdx.x;
    if (i >= static_cast<std::int64_t>(nx) * ny * nz) return;
    const std::int64_t row = i / nx;
    lane[((row / ny) * grid.n[1] + row % ny) * grid.row + i % nx] = static_cast<float>(phi[i]);
}

__device__ cufftComplex correlated(cufftComplex a, cufftComplex b) {  // conj(a) b
    return {a.x * b.x + a.y * b.y, a.x * b.y - a.y * b.x};
}

/// lanes of `a` by the one of `tray`, into `to`; blockIdx.y is the lane.
__global__ void correlate(const cufftComplex* a, const cufftComplex* tray, std::int64_t count, cufftComplex* to) {
    const std::int64_t i = blockIdx.x * static_cast<std::int64_t>(blockDim.x) + threadIdx.x;
    if (i < count) to[blockIdx.y * count + i] = correlated(a[blockIdx.y * count + i], tray[i]);
}

struct Found {
    double cost;
    unsigned long long order;  ///< of (orientation, z, y, x)
};
__device__ bool better(const Found& a, const Found& b) {
    return a.cost < b.cost || (a.cost == b.cost && a.order < b.order);
}

constexpr int kThreads = 256;

__device__ void least_of_block(Found mine, Found* to) {
    __shared__ Found found[kThreads];
    found[threadIdx.x] = mine;
    for (int half = kThreads / 2; half > 0; half /= 2) {
        __syncthreads();
        if (threadIdx.x < half && better(found[threadIdx.x + half], found[threadIdx.x])) {
            found[threadIdx.x] = found[threadIdx.x + half];
        }
    }
    if (threadIdx.x == 0) *to = found[0];
}

/// A block looks at a layer of an orientation: blockIdx.x is the layer, blockIdx.y the orientation.
__global__ void best_of_layers(const float* collision, const float* proximity, const Candidates* all, Grid grid,
                               const double* penalties, Found* found) {
    const int z = blockIdx.x, lane = blockIdx.y;
    const Candidates candidates = all[lane];
    const double scale = 1.0 / (static_cast<double>(grid.n[0]) * grid.n[1] * grid.n[2]);
    Found best{DBL_MAX, ~0ULL};
    if (z < candidates.count[2]) {
        const std::int64_t layer = lane * grid.lane + static_cast<std::int64_t>(z) * grid.n[1] * grid.row;
        for (int i = threadIdx.x; i < candidates.count[0] * candidates.count[1]; i += kThreads) {
            const int x = i % candidates.count[0], y = i / candidates.count[0];
            const std::int64_t at = layer + y * grid.row + x;
            if (collision[at] * scale >= 0.5) continue;
            const auto rho = static_cast<long long>(proximity[at] * scale + 0.5);
            const unsigned long long order =
                ((static_cast<unsigned long long>(lane) * grid.n[2] + z) * grid.n[1] + y) * grid.n[0] + x;
            const Found here{static_cast<double>(rho) + penalties[z], order};
            if (better(here, best)) best = here;
        }
    }
    least_of_block(best, found + lane * gridDim.x + z);
}

__global__ void best_of_all(const Found* found, int count, Found* to) {
    Found best{DBL_MAX, ~0ULL};
    for (int i = threadIdx.x; i < count; i += kThreads) {
        if (better(found[i], best)) best = found[i];
    }
    least_of_block(best, to);
}

int blocks(std::int64_t count) { return static_cast<int>((count + kThreads - 1) / kThreads); }

}  // namespace

struct GpuPlain::Device {
    Grid grid;
    int lanes;
    DeviceArray<float> a, zeta, rho, objects, phi;
    DeviceArray<std::uint64_t> words;
    DeviceArray<std::int32_t> distances;
    DeviceArray<Placed> placed;
    DeviceArray<Candidates> candidates;
    DeviceArray<double> penalties;
    DeviceArray<Found> found;
    struct Plans {
        cufftHandle forward, inverse;
    };
    std::map<int, Plans> plans;  ///< by lanes

    static cufftComplex* spectrum(const DeviceArray<float>& array) {
        return reinterpret_cast<cufftComplex*>(array.data());
    }

    /// Each grid into the lane that its place in the list says; the lanes are zero before.
    void put(const std::vector<const GpuVoxels*>& grids, DeviceArray<float>& to) {
        std::vector<std::uint64_t> all;
        std::vector<Placed> places;
        std::int64_t most_words = 0;
        for (std::size_t lane = 0; lane < grids.size(); ++lane) {
            const GpuVoxels& g = *grids[lane];
            const std::int64_t count = static_cast<std::int64_t>(g.extent[1]) * g.extent[2] * g.words_per_row;
            places.push_back({static_cast<std::int64_t>(all.size()),
                              g.words_per_row,
                              {g.extent[0], g.extent[1], g.extent[2]},
                              {g.offset[0], g.offset[1], g.offset[2]},
                              static_cast<int>(lane)});
            all.insert(all.end(), g.words, g.words + count);
            most_words = std::max(most_words, count);
        }
        words.put(all.data(), all.size());
        placed.put(places.data(), places.size());
        const auto floats = static_cast<std::size_t>(grid.lane) * grids.size();
        check(cudaMemset(to.data(), 0, floats * sizeof(float)));
        const dim3 shape(blocks(most_words), static_cast<unsigned>(grids.size()));
        put_bits<<<shape, kThreads>>>(words.data(), placed.data(), grid, to.data());
        check(cudaGetLastError());
    }
};

GpuPlain::GpuPlain(int nx, int ny, int nz, int orientations) : device_(std::make_unique<Device>()) {
    Device& d = *device_;
    const std::int64_t row = 2 * (nx / 2 + 1);
    d.grid = {{nx, ny, nz}, row, row * ny * nz};
    d.lanes = orientations;
    const auto lane = static_cast<std::size_t>(d.grid.lane);
    for (DeviceArray<float>* array : {&d.a, &d.zeta, &d.rho}) {
        array->grow(lane * static_cast<std::size_t>(orientations));
    }
    d.objects.grow(lane);
    d.phi.grow(lane);
    d.found.grow(static_cast<std::size_t>(orientations) * static_cast<std::size_t>(nz) + 1);
    plan(1);
}

GpuPlain::~GpuPlain() {
    for (const auto& [lanes, plans] : device_->plans) {
        cufftDestroy(plans.forward);
        cufftDestroy(plans.inverse);
    }
}

void GpuPlain::plan(int orientations) {
    Device& d = *device_;
    if (d.plans.count(orientations) > 0) return;
    const int nx = d.grid.n[0], ny = d.grid.n[1], nz = d.grid.n[2], reals = static_cast<int>(d.grid.lane);
    int n[3] = {nz, ny, nx}, real[3] = {nz, ny, static_cast<int>(d.grid.row)}, complex[3] = {nz, ny, nx / 2 + 1};
    Device::Plans plans{};
    check(cufftPlanMany(&plans.forward, 3, n, real, 1, reals, complex, 1, reals / 2, CUFFT_R2C, orientations));
    check(cufftPlanMany(&plans.inverse, 3, n, complex, 1, reals / 2, real, 1, reals, CUFFT_C2R, orientations));
    d.plans.emplace(orientations, plans);
}

void GpuPlain::set_tray(const GpuVoxels& objects, const std::int32_t* phi) {
    Device& d = *device_;
    d.put({&objects}, d.objects);
    const int *e = objects.extent, nx = e[0], ny = e[1], nz = e[2];
    const std::int64_t count = static_cast<std::int64_t>(nx) * ny * nz;
    d.distances.put(phi, static_cast<std::size_t>(count));
    check(cudaMemset(d.phi.data(), 0, d.phi.bytes()));
    put_phi<<<blocks(count), kThreads>>>(d.distances.data(), nx, ny, nz, d.grid, d.phi.data());
    for (DeviceArray<float>* array : {&d.objects, &d.phi}) {
        check(cufftExecR2C(d.plans.at(1).forward, array->data(), d.spectrum(*array)));
    }
    check(cudaDeviceSynchronize());
}

std::optional<GpuBest> GpuPlain::best(const std::vector<GpuOrientation>& orientations,
                                      const std::vector<double>& penalties) {
    Device& d = *device_;
    if (orientations.empty()) return std::nullopt;
    if (static_cast<int>(orientations.size()) > d.lanes) throw std::runtime_error("GPU: more orientations than lanes");
    std::vector<const GpuVoxels*> solids, widened;
    std::vector<Candidates> candidates;
    bool same = true;
    for (const GpuOrientation& o : orientations) {
        solids.push_back(&o.solid);
        widened.push_back(&o.widened);
        candidates.push_back({{o.candidates[0], o.candidates[1], o.candidates[2]}});
        same = same && o.same;
    }
    d.candidates.put(candidates.data(), candidates.size());
    d.penalties.put(penalties.data(), penalties.size());

    plan(static_cast<int>(orientations.size()));
    const Device::Plans& plans = d.plans.at(static_cast<int>(orientations.size()));
    const std::int64_t complexes = d.grid.lane / 2;
    const auto lanes = static_cast<unsigned>(orientations.size());
    const dim3 shape(blocks(complexes), lanes);
    const auto correlate_with = [&](DeviceArray<float>& tray, DeviceArray<float>& sum) {
        correlate<<<shape, kThreads>>>(d.spectrum(d.a), d.spectrum(tray), complexes, d.spectrum(sum));
        check(cudaGetLastError());
        check(cufftExecC2R(plans.inverse, d.spectrum(sum), sum.data()));
    };
    d.put(solids, d.a);
    check(cufftExecR2C(plans.forward, d.a.data(), d.spectrum(d.a)));
    correlate_with(d.phi, d.rho);
    if (!same) {
        d.put(widened, d.a);
        check(cufftExecR2C(plans.forward, d.a.data(), d.spectrum(d.a)));
    }
    correlate_with(d.objects, d.zeta);

    const dim3 layers(static_cast<unsigned>(d.grid.n[2]), lanes);
    const int count = static_cast<int>(lanes) * d.grid.n[2];
    best_of_layers<<<layers, kThreads>>>(d.zeta.data(), d.rho.data(), d.candidates.data(), d.grid, d.penalties.data(),
                                         d.found.data());
    best_of_all<<<1, kThreads>>>(d.found.data(), count, d.found.data() + count);
    check(cudaGetLastError());
    Found found;
    check(cudaMemcpy(&found, d.found.data() + count, sizeof found, cudaMemcpyDeviceToHost));
    if (found.order == ~0ULL) return std::nullopt;

    GpuBest best;
    auto order = static_cast<std::int64_t>(found.order);
    for (int axis = 0; axis < 3; ++axis) {
        best.position[axis] = static_cast<int>(order % d.grid.n[axis]);
        order /= d.grid.n[axis];
    }
    best.index = static_cast<int>(order);
    best.cost = found.cost;
    best.proximity =
        static_cast<std::int64_t>(found.cost - penalties[static_cast<std::size_t>(best.position[2])] + 0.5);
    return best;
}
