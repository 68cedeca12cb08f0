#include "formats/zip_archive.hpp"

#include <zip.h>

#include <utility>

#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

/// The fastest level takes a third of the default's time on meshes, for a quarter more bytes.
constexpr std::uint32_t kDeflateLevel = 1;
/// 1 January 1980, the first day ZIP knows.
constexpr std::uint16_t kNoTime = 0, kNoDate = (1 << 5) | 1;

struct ZipErrorText {
    zip_error_t error;
    ZipErrorText() { zip_error_init(&error); }
    ~ZipErrorText() { zip_error_fini(&error); }
    ZipErrorText(const ZipErrorText&) = delete;
    ZipErrorText& operator=(const ZipErrorText&) = delete;
    std::string text() { return zip_error_strerror(&error); }
};

struct CloseFile {
    void operator()(zip_file_t* file) const { zip_fclose(file); }
};
struct FreeSource {
    void operator()(zip_source_t* source) const { zip_source_free(source); }
};
struct DiscardArchive {
    void operator()(zip_t* archive) const { zip_discard(archive); }
};
using Source = std::unique_ptr<zip_source_t, FreeSource>;
using ArchiveHandle = std::unique_ptr<zip_t, DiscardArchive>;

}  // namespace

struct ZipReader::Archive {
    ArchiveHandle handle;

    std::unique_ptr<zip_file_t, CloseFile> open(const std::string& entry, const std::string& file) const {
        const zip_int64_t index = zip_name_locate(handle.get(), entry.c_str(), ZIP_FL_NOCASE);
        if (index < 0) throw InputError(file, entry, "is not in the archive");
        std::unique_ptr<zip_file_t, CloseFile> opened(
            zip_fopen_index(handle.get(), static_cast<zip_uint64_t>(index), 0));
        if (!opened) throw InputError(file, entry, std::string("cannot be unpacked: ") + zip_strerror(handle.get()));
        return opened;
    }
};

ZipReader::ZipReader(std::string file, std::string_view bytes)
    : file_(std::move(file)), archive_(std::make_unique<Archive>()) {
    ZipErrorText failure;
    Source source(zip_source_buffer_create(bytes.data(), bytes.size(), 0, &failure.error));
    if (source) archive_->handle.reset(zip_open_from_source(source.get(), ZIP_RDONLY, &failure.error));
    if (!archive_->handle) throw InputError(file_, "", "is not a whole ZIP archive: " + failure.text());
    static_cast<void>(source.release());  // the archive's now
}

ZipReader::~ZipReader() = default;

bool ZipReader::has(const std::string& entry) const {
    return zip_name_locate(archive_->handle.get(), entry.c_str(), ZIP_FL_NOCASE) >= 0;
}

void ZipReader::unpack(const std::string& entry, std::uint64_t max_bytes,
                       const std::function<void(std::string_view)>& consume) const {
    const auto file = archive_->open(entry, file_);
    std::uint64_t unpacked = 0;
    std::vector<char> buffer(1 << 16);
    for (;;) {
        const zip_int64_t got = zip_fread(file.get(), buffer.data(), buffer.size());
        if (got < 0) {
            throw InputError(file_, entry, std::string("is damaged: ") + zip_file_strerror(file.get()));
        }
        if (got == 0) return;
        unpacked += static_cast<std::uint64_t>(got);
        if (unpacked > max_bytes) {
            throw InputError(file_, entry,
                             "unpacks to more than " + std::to_string(max_bytes) +
                                 " bytes, far more than its size gives reason to expect");
        }
        consume({buffer.data(), static_cast<std::size_t>(got)});
    }
}

std::string ZipReader::head(const std::string& entry, std::size_t bytes) const {
    const auto file = archive_->open(entry, file_);
    std::string text(bytes, '\0');
    const zip_int64_t got = zip_fread(file.get(), text.data(), text.size());
    if (got < 0) throw InputError(file_, entry, std::string("is damaged: ") + zip_file_strerror(file.get()));
    text.resize(static_cast<std::size_t>(got));
    return text;
}

std::string make_zip(const std::vector<ZipEntry>& entries) {
    ZipErrorText failure;
    const auto fail = [](const std::string& why) -> void { throw ResourceError("cannot pack a ZIP archive: " + why); };
    const Source bytes(zip_source_buffer_create(nullptr, 0, 0, &failure.error));
    if (!bytes) fail(failure.text());
    ArchiveHandle archive(zip_open_from_source(bytes.get(), ZIP_TRUNCATE, &failure.error));
    if (!archive) fail(failure.text());
    zip_source_keep(bytes.get());  // the archive frees one hold of it when it closes
    for (const ZipEntry& entry : entries) {
        Source content(zip_source_buffer(archive.get(), entry.content.data(), entry.content.size(), 0));
        if (!content) fail(zip_strerror(archive.get()));
        const zip_int64_t added = zip_file_add(archive.get(), entry.name.c_str(), content.get(), ZIP_FL_ENC_UTF_8);
        if (added < 0) fail(zip_strerror(archive.get()));
        static_cast<void>(content.release());
        const auto index = static_cast<zip_uint64_t>(added);
        if (zip_set_file_compression(archive.get(), index, ZIP_CM_DEFLATE, kDeflateLevel) != 0 ||
            zip_file_set_dostime(archive.get(), index, kNoTime, kNoDate, 0) != 0) {
            fail(zip_strerror(archive.get()));
        }
    }
    if (zip_close(archive.get()) != 0) fail(zip_strerror(archive.get()));
    static_cast<void>(archive.release());
    zip_stat_t status;
    zip_stat_init(&status);
    if (zip_source_stat(bytes.get(), &status) != 0 || zip_source_open(bytes.get()) != 0) {
        fail(zip_error_strerror(zip_source_error(bytes.get())));
    }
    std::string text(status.size, '\0');
    const zip_int64_t got = zip_source_read(bytes.get(), text.data(), text.size());
    zip_source_close(bytes.get());
    if (got < 0 || static_cast<std::size_t>(got) != text.size()) fail("it cannot be read back");
    return text;
}

}  // namespace spectralpack
