/* image.c - pictures in memory, and the choice of a file format. */
#define _POSIX_C_SOURCE 200809L

#include <brdfcl/image.h>

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

#include "image_formats.h"

#define COUNT(array) (sizeof(array) / sizeof(array)[0])
#define MAGIC_SIZE 8
#define METADATA_NAME_MAX 31 /* OpenEXR, without its long names */

struct image_format {
    const char *suffix;
    const char *magic;
    size_t magic_size;
    brdf_status (*read)(struct brdfcl_image *, const struct brdfcl_image_source *,
                        struct brdf_error *);
    brdf_status (*write)(const struct brdfcl_image *, const struct brdfcl_image_options *,
                         struct brdfcl_atomic_file *, struct brdf_error *);
};

static const struct image_format formats[] = {
    {".exr", "\x76\x2f\x31\x01", 4, brdfcl_image_read_exr, brdfcl_image_write_exr},
    {".png", "\x89PNG\r\n\x1a\n", 8, brdfcl_image_read_png, brdfcl_image_write_png},
};

brdf_status brdfcl_image_size_check(const char *path, long long width, long long height,
                                    struct brdf_error *error)
{
    const char *colon = path ? ": " : "";
    path = path ? path : "";
    if (width < 1 || height < 1)
        return brdf_fail(error, path[0] ? BRDF_BAD_FILE : BRDF_OUT_OF_RANGE,
                         "%s%san image of %lld x %lld pixels has nothing in it", path, colon, width,
                         height);
    if (width > BRDFCL_IMAGE_SIDE_MAX || height > BRDFCL_IMAGE_SIDE_MAX ||
        width * height > BRDFCL_IMAGE_PIXELS_MAX)
        return brdf_fail(
            error, path[0] ? BRDF_BAD_FILE : BRDF_OUT_OF_RANGE,
            "%s%san image of %lld x %lld pixels is too large: at most %ld pixels a side "
            "and %ld in all",
            path, colon, width, height, BRDFCL_IMAGE_SIDE_MAX, BRDFCL_IMAGE_PIXELS_MAX);
    return BRDF_OK;
}

brdf_status brdfcl_image_create(struct brdfcl_image *image, int width, int height,
                                struct brdf_error *error)
{
    memset(image, 0, sizeof *image);
    brdf_status status = brdfcl_image_size_check(NULL, width, height, error);
    if (status != BRDF_OK)
        return status;
    image->rgb = calloc((size_t)width * (size_t)height, 3 * sizeof *image->rgb);
    if (!image->rgb)
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "no memory for an image of %d x %d pixels",
                         width, height);
    image->width = width;
    image->height = height;
    return BRDF_OK;
}

void brdfcl_image_destroy(struct brdfcl_image *image)
{
    if (!image)
        return;
    free(image->rgb);
    memset(image, 0, sizeof *image);
}

long long brdfcl_image_source_read(const struct brdfcl_image_source *source, void *data,
                                   size_t size, long long offset)
{
    size_t done = 0;
    while (done < size) {
        ssize_t n =
            pread(source->fd, (char *)data + done, size - done, (off_t)(offset + (long long)done));
        if (n < 0 && errno == EINTR)
            continue;
        if (n < 0)
            return -1;
        if (n == 0)
            break;
        done += (size_t)n;
    }
    return (long long)done;
}

/* Open a file for reading that is not a folder, a pipe or a device. */
static brdf_status source_open(struct brdfcl_image_source *source, const char *path,
                               struct brdf_error *error)
{
    struct stat info;
    source->path = path;
    /* O_NONBLOCK: opening a pipe that nobody writes to would wait for ever. */
    source->fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (source->fd < 0 || fstat(source->fd, &info) != 0)
        return brdf_fail(error, BRDF_IO, "%s: cannot be read: %s", path, strerror(errno));
    if (S_ISDIR(info.st_mode))
        return brdf_fail(error, BRDF_IO, "%s: is a folder, not an image", path);
    if (!S_ISREG(info.st_mode))
        return brdf_fail(error, BRDF_IO, "%s: is not an ordinary file; save the image in one",
                         path);
    source->size = (long long)info.st_size;
    return BRDF_OK;
}

static const struct image_format *format_by_content(const char *magic, long long size)
{
    for (size_t i = 0; i < COUNT(formats); i++)
        if (size >= (long long)formats[i].magic_size &&
            memcmp(magic, formats[i].magic, formats[i].magic_size) == 0)
            return &formats[i];
    return NULL;
}

brdf_status brdfcl_image_read(struct brdfcl_image *image, const char *path,
                              struct brdf_error *error)
{
    int bits = 0;
    return brdfcl_image_read_numbers(image, path, 0, &bits, error);
}

brdf_status brdfcl_image_read_numbers(struct brdfcl_image *image, const char *path, int raw,
                                      int *bits, struct brdf_error *error)
{
    struct brdfcl_image_source source = {-1, 0, NULL, raw, bits};
    char magic[MAGIC_SIZE];
    memset(image, 0, sizeof *image);
    *bits = 0;
    brdf_status status = source_open(&source, path, error);
    if (status != BRDF_OK)
        goto done;
    long long n = brdfcl_image_source_read(&source, magic, sizeof magic, 0);
    const struct image_format *format = format_by_content(magic, n);
    if (n < 0)
        status = brdf_fail(error, BRDF_IO, "%s: cannot be read: %s", path, strerror(errno));
    else if (n == 0)
        status = brdf_fail(error, BRDF_BAD_FILE, "%s: is empty", path);
    else if (!format)
        status = brdf_fail(error, BRDF_BAD_FILE,
                           "%s: is neither an OpenEXR nor a PNG image, by its first bytes", path);
    else
        status = format->read(image, &source, error);
done:
    if (source.fd >= 0)
        close(source.fd);
    if (status != BRDF_OK)
        brdfcl_image_destroy(image);
    return status;
}

static brdf_status format_by_suffix(const struct image_format **format, const char *path,
                                    struct brdf_error *error)
{
    const char *slash = strrchr(path, '/');
    const char *suffix = strrchr(slash ? slash : path, '.');
    for (size_t i = 0; suffix && i < COUNT(formats); i++)
        if (strcasecmp(suffix, formats[i].suffix) == 0) {
            *format = &formats[i];
            return BRDF_OK;
        }
    return brdf_fail(error, BRDF_UNSUPPORTED,
                     "%s: the suffix says which format to write: use .exr (OpenEXR) or .png (PNG)",
                     path);
}

brdf_status brdfcl_image_path_check(const char *path, struct brdf_error *error)
{
    const struct image_format *format = NULL;
    brdf_status status = format_by_suffix(&format, path, error);
    return status != BRDF_OK ? status : brdfcl_atomic_check(path, error);
}

/* Names that both formats take, and that do not overwrite what OpenEXR itself writes. */
static brdf_status check_metadata_name(const char *name, struct brdf_error *error)
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                  "0123456789_-.";
    static const char *const reserved[] = {
        "channels",           "chromaticities",    "chunkCount", "compression",
        "dataWindow",         "displayWindow",     "lineOrder",  "name",
        "pixelAspectRatio",   "preview",           "tiles",      "type",
        "screenWindowCenter", "screenWindowWidth", "version",    "view",
    };
    size_t length = name ? strlen(name) : 0;
    if (length < 1 || length > METADATA_NAME_MAX || strspn(name, letters) != length)
        return brdf_fail(error, BRDF_BAD_ARGUMENT,
                         "metadata \"%s\": a name is 1 to %d letters, digits, _ - or .",
                         name ? name : "(none)", METADATA_NAME_MAX);
    for (size_t i = 0; i < COUNT(reserved); i++)
        if (strcmp(name, reserved[i]) == 0)
            return brdf_fail(error, BRDF_BAD_ARGUMENT,
                             "metadata \"%s\": OpenEXR keeps this name for itself", name);
    return BRDF_OK;
}

static brdf_status check_options(const struct brdfcl_image_options *options,
                                 struct brdf_error *error)
{
    if (!isfinite(options->exposure))
        return brdf_fail(error, BRDF_BAD_ARGUMENT, "exposure: must be a finite number of stops");
    if (options->metadata_count < 0 || (options->metadata_count > 0 && !options->metadata))
        return brdf_fail(error, BRDF_BAD_ARGUMENT, "metadata: %d entries, but no list of them",
                         options->metadata_count);
    for (int i = 0; i < options->metadata_count; i++) {
        const struct brdfcl_image_metadata *entry = &options->metadata[i];
        brdf_status status = check_metadata_name(entry->name, error);
        if (status != BRDF_OK)
            return status;
        if (entry->kind != BRDFCL_METADATA_TEXT && entry->kind != BRDFCL_METADATA_INT &&
            entry->kind != BRDFCL_METADATA_FLOAT)
            return brdf_fail(error, BRDF_BAD_ARGUMENT, "metadata \"%s\": unknown kind %d",
                             entry->name, (int)entry->kind);
        if (entry->kind == BRDFCL_METADATA_TEXT && !entry->value.text)
            return brdf_fail(error, BRDF_BAD_ARGUMENT, "metadata \"%s\": no text", entry->name);
        for (int j = 0; j < i; j++)
            if (strcmp(entry->name, options->metadata[j].name) == 0)
                return brdf_fail(error, BRDF_BAD_ARGUMENT, "metadata \"%s\": given twice",
                                 entry->name);
    }
    return BRDF_OK;
}

brdf_status brdfcl_image_write(const struct brdfcl_image *image, const char *path,
                               const struct brdfcl_image_options *options, struct brdf_error *error)
{
    static const struct brdfcl_image_options plain = {0, 0.0f, NULL, 0};
    const struct image_format *format = NULL;
    struct brdfcl_atomic_file file;
    options = options ? options : &plain;
    brdf_status status = format_by_suffix(&format, path, error);
    if (status == BRDF_OK)
        status = check_options(options, error);
    if (status == BRDF_OK && (!image || !image->rgb))
        status = brdf_fail(error, BRDF_BAD_ARGUMENT, "%s: there is no image to write", path);
    if (status == BRDF_OK)
        status = brdfcl_image_size_check(NULL, image->width, image->height, error);
    if (status == BRDF_OK)
        status = brdfcl_atomic_open(&file, path, error);
    if (status != BRDF_OK)
        return status;
    status = format->write(image, options, &file, error);
    if (status == BRDF_OK)
        return brdfcl_atomic_commit(&file, error);
    brdfcl_atomic_discard(&file);
    return status;
}

/* FNV-1a over the four bytes of a word, the least significant first. */
static uint64_t hash_word(uint64_t hash, uint32_t word)
{
    for (int shift = 0; shift < 32; shift += 8)
        hash = (hash ^ ((word >> shift) & 0xff)) * UINT64_C(0x100000001b3);
    return hash;
}

unsigned long long brdfcl_image_hash(const struct brdfcl_image *image)
{
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    size_t count = (size_t)image->width * (size_t)image->height * 3;
    hash = hash_word(hash, (uint32_t)image->width);
    hash = hash_word(hash, (uint32_t)image->height);
    for (size_t i = 0; i < count; i++) {
        uint32_t word;
        memcpy(&word, &image->rgb[i], sizeof word);
        hash = hash_word(hash, word);
    }
    return hash;
}
