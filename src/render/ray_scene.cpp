#include "render/ray_scene.hpp"

#include <embree3/rtcore.h>

#include <cstring>
#include <limits>
#include <map>

#include "render/corner_normals.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRoom = 1e-5;  // stage units
constexpr const char* kNoMemory = "not enough memory to draw the picture";

template <class Handle, void (*kRelease)(Handle)>
struct Release {
    using pointer = Handle;
    void operator()(Handle handle) const { kRelease(handle); }
};
using Device = std::unique_ptr<RTCDevice, Release<RTCDevice, rtcReleaseDevice>>;
using EmbreeScene = std::unique_ptr<RTCScene, Release<RTCScene, rtcReleaseScene>>;
using Geometry = std::unique_ptr<RTCGeometry, Release<RTCGeometry, rtcReleaseGeometry>>;

/// A mesh as rays see it, moved and scaled into a unit box: single precision then serves for any
/// coordinates.
struct RayMesh {
    std::shared_ptr<const Mesh> mesh;
    EmbreeScene scene;
    Transform to_mesh;  ///< from the unit box to the mesh's own coordinates
    std::vector<CornerNormals> normals;
    bool inside_out = false;
};

/// What turns normals of a mesh into normals of a copy of it: the cofactors of its linear map,
/// which are the inverse transposed but for a factor, without a division.
Mat3 cofactors(const Mat3& m) {
    return {{cross(m.rows[1], m.rows[2]), cross(m.rows[2], m.rows[0]), cross(m.rows[0], m.rows[1])}};
}

void put(float* at, const Vec3& v) {
    at[0] = static_cast<float>(v.x);
    at[1] = static_cast<float>(v.y);
    at[2] = static_cast<float>(v.z);
}

Vec3 unit_or(const Vec3& v, const Vec3& otherwise) {
    const double size = length(v);
    return size > 0 ? 1 / size * v : otherwise;
}

/// The part of a ray that lies in what is kept, as ray parameters; empty where it enters after it leaves.
struct Reach {
    double enter = 0, leave = kInfinity;
};

Reach reach_in(const std::optional<Kept>& kept, const Vec3& origin, const Vec3& direction) {
    Reach reach;
    if (!kept) return reach;
    const double at = origin[kept->axis], way = direction[kept->axis];
    if (way == 0) return at >= kept->low && at <= kept->high ? reach : Reach{kInfinity, 0};
    const double to_low = (kept->low - at) / way, to_high = (kept->high - at) / way;
    return {std::max(0.0, std::min(to_low, to_high)), std::max(to_low, to_high)};
}

/// Whether the ray meets the box at all: most of those of a floor do not, and asking the library costs ten times as
/// much.
bool meets(const Box& box, const Vec3& origin, const Vec3& direction, const Reach& reach) {
    double enter = reach.enter, leave = reach.leave;
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) {
            if (origin[axis] < box.min[axis] || origin[axis] > box.max[axis]) return false;
            continue;
        }
        const double a = (box.min[axis] - origin[axis]) / direction[axis];
        const double b = (box.max[axis] - origin[axis]) / direction[axis];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave;
}

RTCRay ray_from(const Vec3& origin, const Vec3& direction, const Reach& reach) {
    RTCRay ray{};
    put(&ray.org_x, origin);
    put(&ray.dir_x, direction);
    ray.tnear = static_cast<float>(reach.enter);
    ray.tfar = static_cast<float>(reach.leave);
    ray.mask = ~0u;
    return ray;
}

RTCRayHit hit_from(RTCScene scene, const Vec3& origin, const Vec3& direction, const Reach& reach) {
    RTCRayHit ray{};
    ray.ray = ray_from(origin, direction, reach);
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect1(scene, &context, &ray);
    return ray;
}

void expect_success(RTCDevice device) {
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) throw ResourceError(kNoMemory);
}

RayMesh hold(RTCDevice device, std::shared_ptr<const Mesh> shared) {
    const Mesh& mesh = *shared;
    RayMesh result;
    const Box box = bounding_box(mesh);
    const Vec3 size = box.size();
    const double scale = std::max({size.x, size.y, size.z, std::numeric_limits<double>::min()});
    result.to_mesh.linear = scale * Mat3{};
    result.to_mesh.translation = 0.5 * (box.min + box.max);
    const Geometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size()));
    void* triangles = rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                              sizeof(Triangle), mesh.triangles.size());
    expect_success(device);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        put(vertices + 3 * i, 1 / scale * (mesh.vertices[i] - result.to_mesh.translation));
    }
    std::memcpy(triangles, mesh.triangles.data(), mesh.triangles.size() * sizeof(Triangle));
    rtcCommitGeometry(geometry.get());
    result.scene.reset(rtcNewScene(device));
    rtcSetSceneFlags(result.scene.get(), RTC_SCENE_FLAG_ROBUST);
    rtcAttachGeometry(result.scene.get(), geometry.get());
    rtcCommitScene(result.scene.get());
    expect_success(device);
    result.normals = corner_normals(mesh);
    result.inside_out = signed_volume(mesh) < 0;
    result.mesh = std::move(shared);
    return result;
}

}  // namespace

struct RayMeshes::Held {
    Device device;
    std::map<const Mesh*, RayMesh> meshes;  ///< looked up only, never walked: its order is by address
};

RayMeshes::RayMeshes() : held_(std::make_unique<Held>()) {
    // Not "threads=1": that would limit the threads of the whole process while the device lives.
    // The hierarchy comes out the same for any number of them.
    held_->device.reset(rtcNewDevice(nullptr));
    if (!held_->device) {
        const bool unsupported = rtcGetDeviceError(nullptr) == RTC_ERROR_UNSUPPORTED_CPU;
        throw ResourceError(unsupported ? "the ray tracing library cannot run on this machine" : kNoMemory);
    }
}

RayMeshes::~RayMeshes() = default;

void RayMeshes::add(const std::vector<std::shared_ptr<const Mesh>>& meshes, const Workers& workers) {
    std::vector<std::pair<std::shared_ptr<const Mesh>, RayMesh*>> fresh;
    for (const auto& mesh : meshes) {
        if (!mesh) continue;
        const auto [at, is_new] = held_->meshes.try_emplace(mesh.get());
        if (is_new) fresh.emplace_back(mesh, &at->second);
    }
    workers.for_each(static_cast<std::int64_t>(fresh.size()), [&](std::int64_t i) {
        auto& [mesh, held] = fresh[static_cast<std::size_t>(i)];
        *held = hold(held_->device.get(), mesh);
    });
}

struct RayScene::Held {
    RTCDevice device = nullptr;
    EmbreeScene all, keep_outs;
    std::vector<const RayMesh*> mesh_of;  ///< by copy
    std::vector<Mat3> normals_to;         ///< by copy: turns its mesh's normals into the stage's
    std::vector<bool> inside_out;         ///< by copy: facets that face the ray are those it leaves by
    std::optional<Kept> kept;
    Box bounds;  ///< of all copies, with a little room for what is lost in single precision

    EmbreeScene instances(const std::vector<StagedCopy>& copies, const std::vector<const RayMesh*>& meshes) const {
        EmbreeScene scene(rtcNewScene(device));
        for (std::size_t i = 0; i < copies.size(); ++i) {
            const RayMesh& mesh = *meshes[static_cast<std::size_t>(copies[i].mesh)];
            const Transform pose = copies[i].pose * mesh.to_mesh;
            const Mat3 columns = transposed(pose.linear);
            float matrix[12];
            for (std::size_t k = 0; k < 3; ++k) {
                put(matrix + 3 * k, columns.rows[k]);
            }
            put(matrix + 9, pose.translation);
            const Geometry instance(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE));
            rtcSetGeometryInstancedScene(instance.get(), mesh.scene.get());
            rtcSetGeometryTransform(instance.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, matrix);
            rtcCommitGeometry(instance.get());
            rtcAttachGeometryByID(scene.get(), instance.get(), static_cast<unsigned>(i));
        }
        rtcCommitScene(scene.get());
        return scene;
    }
};

RayScene::RayScene(const Stage& stage, const RayMeshes& meshes) : held_(std::make_unique<Held>()) {
    held_->device = meshes.held_->device.get();
    held_->kept = stage.kept;
    std::vector<const RayMesh*> held;
    for (const auto& mesh : stage.meshes) {
        held.push_back(&meshes.held_->meshes.at(mesh.get()));
    }
    held_->all = held_->instances(stage.copies, held);
    if (!stage.keep_outs.empty()) held_->keep_outs = held_->instances(stage.keep_outs, held);
    for (const StagedCopy& copy : stage.copies) {
        const RayMesh& mesh = *held[static_cast<std::size_t>(copy.mesh)];
        const Transform pose = copy.pose * mesh.to_mesh;
        held_->mesh_of.push_back(&mesh);
        held_->normals_to.push_back(cofactors(pose.linear));
        held_->inside_out.push_back(mesh.inside_out != (determinant(pose.linear) < 0));
    }
    RTCBounds bounds;
    rtcGetSceneBounds(held_->all.get(), &bounds);
    const Vec3 room{kRoom, kRoom, kRoom};
    held_->bounds = {Vec3{bounds.lower_x, bounds.lower_y, bounds.lower_z} - room,
                     Vec3{bounds.upper_x, bounds.upper_y, bounds.upper_z} + room};
    expect_success(held_->device);
}

RayScene::~RayScene() = default;

RayHit RayScene::first(const Vec3& origin, const Vec3& direction) const {
    const Reach reach = reach_in(held_->kept, origin, direction);
    if (reach.enter > reach.leave || !meets(held_->bounds, origin, direction, {reach.enter, kInfinity})) return {};
    const RTCRayHit ray = hit_from(held_->all.get(), origin, direction, {reach.enter, kInfinity});
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};

    RayHit hit;
    hit.copy = static_cast<int>(ray.hit.instID[0]);
    hit.at = ray.ray.tfar;
    const auto copy = static_cast<std::size_t>(hit.copy);
    const Mat3& to_stage = held_->normals_to[copy];
    const CornerNormals& corners = held_->mesh_of[copy]->normals[ray.hit.primID];
    const double u = ray.hit.u, v = ray.hit.v, w = 1 - u - v;
    const auto mixed = [&](std::size_t axis) {
        return w * corners[0][axis] + u * corners[1][axis] + v * corners[2][axis];
    };
    const Vec3 face = to_stage * Vec3{ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z};
    const bool leaving = (dot(face, direction) > 0) != held_->inside_out[copy];
    if (leaving && reach.enter > 0) {
        hit.cut = true;
        hit.at = reach.enter;
        hit.face[held_->kept->axis] = direction[held_->kept->axis] > 0 ? -1 : 1;
        hit.smooth = hit.face;
        return hit;
    }
    if (hit.at > reach.leave) return {};
    // Seen from inside, or of an inside-out mesh: turned towards the viewer.
    const double side = dot(face, direction) > 0 ? -1 : 1;
    hit.face = unit_or(side * face, unit_or(-direction, {0, 0, 1}));
    hit.smooth = unit_or(side * (to_stage * Vec3{mixed(0), mixed(1), mixed(2)}), hit.face);
    return hit;
}

bool RayScene::blocked(const Vec3& origin, const Vec3& direction, double reach) const {
    Reach within = reach_in(held_->kept, origin, direction);
    within.leave = std::min(within.leave, reach);
    if (within.enter > within.leave || !meets(held_->bounds, origin, direction, within)) return false;
    RTCRay ray = ray_from(origin, direction, within);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(held_->all.get(), &context, &ray);
    return ray.tfar < 0;
}

double RayScene::keep_out(const Vec3& origin, const Vec3& direction) const {
    if (!held_->keep_outs) return kInfinity;
    const Reach reach = reach_in(held_->kept, origin, direction);
    if (reach.enter > reach.leave) return kInfinity;
    const RTCRayHit ray = hit_from(held_->keep_outs.get(), origin, direction, {reach.enter, kInfinity});
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return kInfinity;
    // Out of what is cut away into the middle of it. Keep-outs are scaled, never turned.
    const bool leaving = dot(Vec3{ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z}, direction) > 0;
    const double at = leaving && reach.enter > 0 ? reach.enter : static_cast<double>(ray.ray.tfar);
    return at <= reach.leave ? at : kInfinity;
}

}  // namespace spectralpack
