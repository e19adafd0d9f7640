/*
 * tensor.c - the header of a tensor file: everything that can be wrong with it, before anything is
 * believed or allocated.
 */
#include "tensor.h"

#include <errno.h>
#include <string.h>

const unsigned char brdf_tensor_magic[BRDF_TENSOR_MAGIC] = "tensor_file";

/* Of one element of each type: none, integers of 8 to 64 bits without and with a sign, floats. */
static const unsigned char type_bytes[BRDF_TENSOR_TYPES] = {0, 1, 1, 2, 2, 4, 4, 8, 8, 2, 4, 8};

/* The next bytes of the header. */
brdf_status brdf_tensor_take(struct brdf_tensor_file *source, void *bytes, int count,
                             struct brdf_error *error)
{
    if (source->size - source->at < count) {
        return brdf_fail(error, BRDF_BAD_FILE,
                         "%s: byte %lld: the file ends within its header: it is cut off",
                         source->path, source->size);
    }
    if (fread(bytes, 1, (size_t)count, source->stream) != (size_t)count) {
        return brdf_fail(error, BRDF_IO, "%s: byte %lld: cannot be read: %s", source->path,
                         source->at,
                         ferror(source->stream) ? strerror(errno) : "the file has shrunk");
    }
    source->at += count;
    return BRDF_OK;
}

/* A little-endian number of the header. */
static brdf_status source_number(struct brdf_tensor_file *source, int bytes, uint64_t *number,
                                 struct brdf_error *error)
{
    unsigned char buffer[8];
    brdf_status status = brdf_tensor_take(source, buffer, bytes, error);
    if (!status) {
        *number = brdf_little(buffer, bytes);
    }
    return status;
}

/* A name of any length, of which the first bytes are kept. */
static brdf_status source_name(struct brdf_tensor_file *source, char *name, size_t size,
                               struct brdf_error *error)
{
    uint64_t length;
    brdf_status status = source_number(source, 2, &length, error);
    size_t kept = 0;
    for (uint64_t i = 0; i < length && !status; ++i) {
        char c;
        status = brdf_tensor_take(source, &c, 1, error);
        if (!status && kept + 1 < size) {
            name[kept++] = c;
        }
    }
    name[kept] = '\0';
    return status;
}

static int field_find(const char *name)
{
    for (int k = 0; k < BRDF_RGL_FIELDS; ++k) {
        if (strcmp(name, brdf_rgl_field_kinds[k].name) == 0) {
            return k;
        }
    }
    return -1;
}

/* The dimensions of a field and the bytes of its data, with nothing that can overflow. */
static brdf_status source_shape(struct brdf_tensor_file *source, const char *name, uint64_t rank,
                                int width, struct brdf_tensor *tensor, struct brdf_error *error)
{
    long long limit = source->size / width; /* no honest field has more elements */
    tensor->elements = 1;
    for (uint64_t i = 0; i < rank; ++i) {
        long long at = source->at;
        uint64_t dimension;
        brdf_status status = source_number(source, 8, &dimension, error);
        if (status) {
            return status;
        }
        if (dimension > (uint64_t)limit ||
            (dimension > 0 && tensor->elements > limit / (long long)dimension)) {
            return brdf_fail(error, BRDF_BAD_FILE,
                             "%s: byte %lld: dimension %d of \"%s\" is %llu: the field would be "
                             "larger than the file of %lld bytes",
                             source->path, at, (int)i, name, (unsigned long long)dimension,
                             source->size);
        }
        tensor->elements *= (long long)dimension;
        if (i < BRDF_TENSOR_RANK_MAX) {
            tensor->dimension[i] = (long long)dimension;
        }
    }
    return BRDF_OK;
}

/* One description of a field: kept if it is one of ours, else only checked. */
static brdf_status source_field(struct brdf_tensor_file *source, struct brdf_error *error)
{
    char name[32];
    uint64_t rank, type, data;
    struct brdf_tensor tensor = {1, source->at, 0, 0, {0}};
    brdf_status status = source_name(source, name, sizeof name, error);
    status = status ? status : source_number(source, 2, &rank, error);
    status = status ? status : source_number(source, 1, &type, error);
    status = status ? status : source_number(source, 8, &data, error);
    if (status) {
        return status;
    }
    if (type == 0 || type >= BRDF_TENSOR_TYPES) {
        return brdf_fail(error, BRDF_BAD_FILE, "%s: byte %lld: \"%s\" has the unknown type %d",
                         source->path, tensor.header, name, (int)type);
    }
    int field = field_find(name);
    if (field >= 0 &&
        (source->field[field].found || (int)rank != brdf_rgl_field_kinds[field].rank ||
         (int)type != brdf_rgl_field_kinds[field].type)) {
        return brdf_fail(error, BRDF_BAD_FILE,
                         source->field[field].found
                             ? "%s: byte %lld: there is a second field \"%s\""
                             : "%s: byte %lld: \"%s\" has rank %d and type %d, but must have rank "
                               "%d and type %d",
                         source->path, tensor.header, name, (int)rank, (int)type,
                         brdf_rgl_field_kinds[field].rank, brdf_rgl_field_kinds[field].type);
    }
    int width = type_bytes[type];
    status = source_shape(source, name, rank, width, &tensor, error);
    if (status) {
        return status;
    }
    long long bytes = tensor.elements * width;
    if (data > (uint64_t)source->size || bytes > source->size - (long long)data) {
        return brdf_fail(error, BRDF_BAD_FILE,
                         "%s: byte %lld: the %lld bytes of \"%s\" at byte %llu lie outside of the "
                         "file of %lld bytes: it is cut off or damaged",
                         source->path, tensor.header, bytes, name, (unsigned long long)data,
                         source->size);
    }
    tensor.data = (long long)data;
    if (tensor.data + bytes > source->end) {
        source->end = tensor.data + bytes;
    }
    if (field >= 0) {
        source->field[field] = tensor;
    }
    return BRDF_OK;
}

/* The whole header, and that nothing follows the data. */
brdf_status brdf_tensor_header(struct brdf_tensor_file *source, struct brdf_error *error)
{
    unsigned char prologue[BRDF_TENSOR_PROLOGUE];
    if (source->size < (long long)sizeof prologue) {
        return brdf_fail(error, BRDF_BAD_FILE,
                         "%s: %lld bytes are too short for a tensor file's header", source->path,
                         source->size);
    }
    brdf_status status = brdf_tensor_take(source, prologue, sizeof prologue, error);
    if (status) {
        return status;
    }
    if (memcmp(prologue, brdf_tensor_magic, sizeof brdf_tensor_magic) != 0) {
        return brdf_fail(
            error, BRDF_BAD_FILE,
            "%s: byte 0: it does not begin with \"tensor_file\": not an RGL .bsdf file",
            source->path);
    }
    if (prologue[12] != 1 || prologue[13] != 0) {
        return brdf_fail(error, BRDF_BAD_FILE, "%s: byte 12: version %d.%d is not known, only 1.0",
                         source->path, prologue[12], prologue[13]);
    }
    uint64_t fields = brdf_little(prologue + 14, 4);
    for (uint64_t i = 0; i < fields && !status; ++i) {
        status = source_field(source, error);
    }
    if (!status && source->size - source->end >= 8) {
        return brdf_fail(error, BRDF_BAD_FILE,
                         "%s: byte %lld: the data end here, but the file has %lld bytes: it is too "
                         "long",
                         source->path, source->end, source->size);
    }
    return status;
}
