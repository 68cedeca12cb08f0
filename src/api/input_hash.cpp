#include "api/input_hash.hpp"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <memory>

#include "api/check_options.hpp"
#include "spectralpack/option_table.hpp"

namespace spectralpack {
namespace {

class Hash {
  public:
    Hash() : state_(XXH3_createState()) { XXH3_128bits_reset(state_); }
    ~Hash() { XXH3_freeState(state_); }
    Hash(const Hash&) = delete;
    Hash& operator=(const Hash&) = delete;

    template <class T>
    void add(const T& value) {
        static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
        XXH3_128bits_update(state_, &value, sizeof value);
    }
    void add(const std::string& text) {
        add(text.size());
        XXH3_128bits_update(state_, text.data(), text.size());
    }
    void add(const Mesh& mesh) {
        add(mesh.vertices.size());
        XXH3_128bits_update(state_, mesh.vertices.data(), mesh.vertices.size() * sizeof(Vec3));
        add(mesh.triangles.size());
        XXH3_128bits_update(state_, mesh.triangles.data(), mesh.triangles.size() * sizeof(Triangle));
    }
    void add(const Vec3& v) {
        add(v.x);
        add(v.y);
        add(v.z);
    }
    void add(const Transform& transform) {
        for (const Vec3& row : transform.linear.rows) {
            add(row);
        }
        add(transform.translation);
    }
    void add(const PartOrientations& orientations) {
        add(orientations.kind);
        add(orientations.yaw.value_or(-1));
        for (const SignedAxis& axis : orientations.up) {
            add(axis.axis);
            add(axis.positive);
        }
        for (const Mat3& matrix : orientations.matrices) {
            XXH3_128bits_update(state_, &matrix, sizeof matrix);
        }
    }
    /// In the bytes of the fields of PackOptions, an enum's being its position; -1 for none.
    void add(const Option& option, const OptionValue& value) {
        const bool none = std::holds_alternative<std::monostate>(value);
        switch (option.type) {
            case OptionType::flag:
                return add(std::get<bool>(value));
            case OptionType::integer:
                return add(static_cast<int>(std::get<std::int64_t>(value)));
            case OptionType::natural:
                return add(std::get<std::uint64_t>(value));
            case OptionType::number:
                return add(none ? -1 : std::get<double>(value));
            case OptionType::size:
                return add(std::get<Vec3>(value));
            case OptionType::word: {
                const auto word =
                    none ? option.words.end() : std::ranges::find(option.words, std::get<std::string>(value));
                return add(none ? -1 : static_cast<int>(word - option.words.begin()));
            }
            case OptionType::rotations:
                return add(std::get<std::string>(value));
            default:
                throw InternalError("the input hash holds no option like --" + std::string(option.name));
        }
    }
    std::string hex() const {
        const XXH128_hash_t hash = XXH3_128bits_digest(state_);
        char text[33];
        std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                      static_cast<unsigned long long>(hash.low64));
        return text;
    }

  private:
    XXH3_state_t* state_;
};

/// Later options count where they are not as by default, so that they change the hash of no run without them.
constexpr int kAlwaysHashed = 23;

/// Those that placements depend on.
std::vector<const Option*> hashed_options() {
    std::vector<const Option*> options;
    for (const Option& option : option_table()) {
        if (option.hash_place > 0) options.push_back(&option);
    }
    std::ranges::sort(options, {}, &Option::hash_place);
    return options;
}

/// Options that say how a run goes, not what comes out.
bool is_about_the_run(const Option& option) {
    constexpr std::array<std::string_view, 5> kOfTheRun{"printer", "engine", "threads", "memory", "time-limit"};
    return std::ranges::find(kOfTheRun, option.name) != kOfTheRun.end();
}

}  // namespace

std::string input_hash(const LoadedJob& loaded, const Container& container, const PackOptions& options) {
    Hash hash;
    for (std::size_t i = 0; i < loaded.parts.size(); ++i) {
        const PackedPart& part = loaded.parts[i];
        if (!loaded.meshes[i]) continue;
        hash.add(*loaded.meshes[i]);
        hash.add(part.count);
        hash.add(part.to_mm());
        hash.add(part.gap);
        hash.add(part.priority);
        hash.add(part.due);
        hash.add(part.orientations);
        if (options.goal == Goal::value) hash.add(part.value);
    }
    for (const FixedPlacement& fixed : loaded.fixed) {
        hash.add(fixed.tray);
        hash.add(fixed.placement.part);
        hash.add(fixed.placement.transform);
    }
    hash.add(container.mesh.has_value());
    if (container.mesh) hash.add(*container.mesh->surface);
    for (const KeepOut& keep_out : container.keep_out) {
        hash.add(keep_out.box.min);
        hash.add(keep_out.box.max);
        if (keep_out.mesh) hash.add(*keep_out.mesh->surface);
    }
    hash.add(container.physical);
    PackOptions decisive = options;
    if (options.trays == 1) decisive.try_per_tray = 0;
    if (options.order != Order::random && options.restarts == 1 && !improves(options)) decisive.seed = 0;
    for (const Option* option : hashed_options()) {
        const OptionValue value = option->in_pack.get(decisive);
        if (option->hash_place <= kAlwaysHashed || value != default_of(*option)) hash.add(*option, value);
    }
    return hash.hex();
}

std::vector<InputFact> input_facts(const LoadedJob& loaded, const Container& container, const PackOptions& options) {
    std::vector<InputFact> facts;
    const auto hash_of = [](const auto&... values) {
        Hash hash;
        (hash.add(values), ...);
        return hash.hex();
    };
    // First what people most often say another time; parts take their gaps and orientations from it.
    for (const Option& option : option_table()) {
        if (!option.in_pack.get || is_about_the_run(option)) continue;
        const OptionValue value = option.in_pack.get(options);
        // How long it improves is nothing to what it goes on from.
        const bool seconds = option.name == "improve" && !std::holds_alternative<std::monostate>(value);
        facts.push_back({"option " + std::string(option.name), seconds ? "so many seconds" : text_of(option, value)});
    }
    std::map<const Mesh*, std::string> meshes;
    const auto mesh_hash = [&](const std::shared_ptr<const Mesh>& mesh) -> const std::string& {
        const auto [known, fresh] = meshes.try_emplace(mesh.get());
        if (fresh) known->second = mesh ? hash_of(*mesh) : "none";
        return known->second;
    };
    for (std::size_t i = 0; i < loaded.parts.size(); ++i) {
        const PackedPart& part = loaded.parts[i];
        const std::string name = "part " + std::to_string(i + 1) + " (" + part.name + ")";
        facts.push_back({name + ", count", std::to_string(part.count)});
        facts.push_back({name + ", mesh", mesh_hash(loaded.meshes[i])});
        facts.push_back({name + ", size, gap, orientations, order and value",
                         hash_of(part.to_mm(), part.gap, part.priority, part.due, part.orientations, part.value)});
    }
    for (const FixedPlacement& fixed : loaded.fixed) {
        facts.push_back(
            {"copies that stand there already", hash_of(fixed.tray, fixed.placement.part, fixed.placement.transform)});
    }
    facts.push_back({"container mesh", container.mesh ? hash_of(*container.mesh->surface) : "none"});
    facts.push_back({"container's walls", container.physical ? "physical" : "virtual"});
    for (const KeepOut& keep_out : container.keep_out) {
        facts.push_back({"keep-out", keep_out.mesh ? hash_of(*keep_out.mesh->surface)
                                                   : hash_of(keep_out.box.min, keep_out.box.max)});
    }
    return facts;
}

std::string chained_hash(const std::string& before, const std::string& text) {
    const std::string all = before + text;
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx",
                  static_cast<unsigned long long>(XXH3_64bits(all.data(), all.size())));
    return digits;
}

}  // namespace spectralpack
