#include "render/ray_scene.hpp"

#include <embree3/rtcore.h>

#include <cstring>
#include <limits>

#include "render/corner_normals.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

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
    EmbreeScene scene;
    Transform to_mesh;  ///< from the unit box to the mesh's own coordinates
    std::vector<CornerNormals> normals;
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

RTCRay ray_from(const Vec3& origin, const Vec3& direction, double reach) {
    RTCRay ray{};
    put(&ray.org_x, origin);
    put(&ray.dir_x, direction);
    ray.tfar = static_cast<float>(reach);
    ray.mask = ~0u;
    return ray;
}

}  // namespace

struct RayScene::Held {
    Device device;
    std::vector<RayMesh> meshes;
    EmbreeScene all;
    std::vector<int> mesh_of;      ///< by copy
    std::vector<Mat3> normals_to;  ///< by copy: turns its mesh's normals into the stage's

    void expect_success() const {
        if (rtcGetDeviceError(device.get()) != RTC_ERROR_NONE) {
            throw ResourceError("not enough memory to draw the picture");
        }
    }

    RayMesh hold(const Mesh& mesh) const {
        RayMesh result;
        const Box box = bounding_box(mesh);
        const Vec3 size = box.size();
        const double scale = std::max({size.x, size.y, size.z, std::numeric_limits<double>::min()});
        result.to_mesh.linear = scale * Mat3{};
        result.to_mesh.translation = 0.5 * (box.min + box.max);
        const Geometry geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
        auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size()));
        void* triangles = rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                  sizeof(Triangle), mesh.triangles.size());
        expect_success();
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
            put(vertices + 3 * i, 1 / scale * (mesh.vertices[i] - result.to_mesh.translation));
        }
        std::memcpy(triangles, mesh.triangles.data(), mesh.triangles.size() * sizeof(Triangle));
        rtcCommitGeometry(geometry.get());
        result.scene.reset(rtcNewScene(device.get()));
        rtcSetSceneFlags(result.scene.get(), RTC_SCENE_FLAG_ROBUST);
        rtcAttachGeometry(result.scene.get(), geometry.get());
        rtcCommitScene(result.scene.get());
        expect_success();
        result.normals = corner_normals(mesh);
        return result;
    }
};

RayScene::RayScene(const Stage& stage) : held_(std::make_unique<Held>()) {
    // Not "threads=1": that would limit the threads of the whole process while the device lives.
    // The hierarchy comes out the same for any number of them.
    held_->device.reset(rtcNewDevice(nullptr));
    if (!held_->device) throw ResourceError("the ray tracing library cannot run on this machine");
    for (const auto& mesh : stage.meshes) {
        held_->meshes.push_back(held_->hold(*mesh));
    }
    held_->all.reset(rtcNewScene(held_->device.get()));
    for (std::size_t i = 0; i < stage.copies.size(); ++i) {
        const StagedCopy& copy = stage.copies[i];
        const RayMesh& mesh = held_->meshes[static_cast<std::size_t>(copy.mesh)];
        const Transform pose = copy.pose * mesh.to_mesh;
        const Mat3 columns = transposed(pose.linear);
        float matrix[12];
        for (std::size_t k = 0; k < 3; ++k) {
            put(matrix + 3 * k, columns.rows[k]);
        }
        put(matrix + 9, pose.translation);
        const Geometry instance(rtcNewGeometry(held_->device.get(), RTC_GEOMETRY_TYPE_INSTANCE));
        rtcSetGeometryInstancedScene(instance.get(), mesh.scene.get());
        rtcSetGeometryTransform(instance.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, matrix);
        rtcCommitGeometry(instance.get());
        rtcAttachGeometryByID(held_->all.get(), instance.get(), static_cast<unsigned>(i));
        held_->mesh_of.push_back(copy.mesh);
        held_->normals_to.push_back(cofactors(pose.linear));
    }
    rtcCommitScene(held_->all.get());
    held_->expect_success();
}

RayScene::~RayScene() = default;

RayHit RayScene::first(const Vec3& origin, const Vec3& direction) const {
    RTCRayHit ray{};
    ray.ray = ray_from(origin, direction, std::numeric_limits<double>::infinity());
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect1(held_->all.get(), &context, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};

    RayHit hit;
    hit.copy = static_cast<int>(ray.hit.instID[0]);
    hit.at = ray.ray.tfar;
    const auto copy = static_cast<std::size_t>(hit.copy);
    const Mat3& to_stage = held_->normals_to[copy];
    const CornerNormals& corners =
        held_->meshes[static_cast<std::size_t>(held_->mesh_of[copy])].normals[ray.hit.primID];
    const double u = ray.hit.u, v = ray.hit.v, w = 1 - u - v;
    const auto mixed = [&](std::size_t axis) {
        return w * corners[0][axis] + u * corners[1][axis] + v * corners[2][axis];
    };
    const Vec3 face = to_stage * Vec3{ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z};
    // Seen from inside, or of an inside-out mesh: turned towards the viewer.
    const double side = dot(face, direction) > 0 ? -1 : 1;
    hit.face = unit_or(side * face, unit_or(-direction, {0, 0, 1}));
    hit.smooth = unit_or(side * (to_stage * Vec3{mixed(0), mixed(1), mixed(2)}), hit.face);
    return hit;
}

bool RayScene::blocked(const Vec3& origin, const Vec3& direction, double reach) const {
    RTCRay ray = ray_from(origin, direction, reach);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(held_->all.get(), &context, &ray);
    return ray.tfar < 0;
}

}  // namespace spectralpack
