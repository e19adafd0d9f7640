/*
 * image_exr_header.c - which part and which channels of an OpenEXR file are the picture, and why
 * not.
 */
#include "image_exr.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

brdf_status brdfcl_exr_fail(const struct exr_reader *reader, exr_result_t code,
                            struct brdf_error *error)
{
    const char *path = reader->source->path;
    if (reader->read_errno)
        return brdf_fail(error, BRDF_IO, "%s: cannot be read: %s", path,
                         strerror(reader->read_errno));
    if (code == EXR_ERR_OUT_OF_MEMORY)
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "%s: out of memory while reading it", path);
    if (code == EXR_ERR_READ_IO)
        return brdf_fail(error, BRDF_BAD_FILE,
                         "%s: is cut short or damaged: OpenEXR data beyond its end at byte %lld",
                         path, reader->source->size);
    return brdf_fail(error, BRDF_BAD_FILE, "%s: not valid OpenEXR: %s", path,
                     reader->message[0] ? reader->message : exr_get_default_error_message(code));
}

static brdf_status fail_channels(const struct exr_reader *reader, struct brdf_error *error)
{
    char names[512] = "";
    size_t used = 0;
    const exr_attr_chlist_t *list = reader->channels;
    for (int c = 0; list && c < list->num_channels && used < sizeof names; c++)
        used += (size_t)snprintf(names + used, sizeof names - used, "%s%s", c ? ", " : "",
                                 list->entries[c].name.str);
    return brdf_fail(error, BRDF_BAD_FILE, "%s: needs the channels R, G and B, or Y; found: %s",
                     reader->source->path, names[0] ? names : "none");
}

/* The index of the channel of that name, or -1. */
static int find_channel(const exr_attr_chlist_t *list, const char *name)
{
    for (int c = 0; c < list->num_channels; c++)
        if (strcmp(list->entries[c].name.str, name) == 0)
            return c;
    return -1;
}

/* Set channels, colour and plane from the current part; not 0 if it has what is needed. */
static int find_colours(struct exr_reader *reader)
{
    static const char *const names[EXR_COLOURS] = {"R", "G", "B"};
    reader->channels = NULL;
    if (exr_get_channels(reader->context, reader->part, &reader->channels) != EXR_ERR_SUCCESS ||
        !reader->channels)
        return 0;
    int found = 0;
    for (int i = 0; i < EXR_COLOURS; i++) {
        reader->colour[i] = find_channel(reader->channels, names[i]);
        reader->plane[i] = i;
        found += reader->colour[i] >= 0;
    }
    int luminance = find_channel(reader->channels, "Y");
    if (found == 0 && luminance >= 0) {
        for (int i = 0; i < EXR_COLOURS; i++) {
            reader->colour[i] = luminance;
            reader->plane[i] = 0;
        }
        return 1;
    }
    return found == EXR_COLOURS;
}

static int is_deep(const struct exr_reader *reader)
{
    exr_storage_t storage = EXR_STORAGE_SCANLINE;
    exr_get_storage(reader->context, reader->part, &storage);
    return storage == EXR_STORAGE_DEEP_SCANLINE || storage == EXR_STORAGE_DEEP_TILED;
}

/* Choose the first part that is a picture in colour or grey. */
static brdf_status find_part(struct exr_reader *reader, struct brdf_error *error)
{
    int count = 0, deep = 0;
    exr_result_t code = exr_get_count(reader->context, &count);
    if (code != EXR_ERR_SUCCESS)
        return brdfcl_exr_fail(reader, code, error);
    for (reader->part = 0; reader->part < count; reader->part++) {
        if (is_deep(reader))
            deep++;
        else if (find_colours(reader))
            return BRDF_OK;
    }
    if (deep > 0 && deep == count)
        return brdf_fail(error, BRDF_UNSUPPORTED, "%s: deep OpenEXR images are not supported",
                         reader->source->path);
    reader->part = 0;
    find_colours(reader);
    return fail_channels(reader, error);
}

static brdf_status check_sampling(const struct exr_reader *reader, struct brdf_error *error)
{
    for (int c = 0; c < reader->channels->num_channels; c++) {
        const exr_attr_chlist_entry_t *channel = &reader->channels->entries[c];
        if (channel->x_sampling != 1 || channel->y_sampling != 1)
            return brdf_fail(
                error, BRDF_UNSUPPORTED,
                "%s: channel %s has one value for %d x %d pixels; only one for each is "
                "supported",
                reader->source->path, channel->name.str, (int)channel->x_sampling,
                (int)channel->y_sampling);
    }
    return BRDF_OK;
}

/* Refuse other primaries than those of Rec. 709, which is what files without the attribute have. */
static brdf_status check_primaries(const struct exr_reader *reader, struct brdf_error *error)
{
    static const float rec709[8] = {0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f};
    const float tolerance = 0.002f; /* rounding in the programs that write them */
    const exr_attribute_t *attribute = NULL;
    exr_attr_chromaticities_t found;
    if (exr_get_attribute_by_name(reader->context, reader->part, "chromaticities", &attribute) !=
            EXR_ERR_SUCCESS ||
        exr_attr_get_chromaticities(reader->context, reader->part, "chromaticities", &found) !=
            EXR_ERR_SUCCESS)
        return BRDF_OK;
    const float values[8] = {found.red_x,  found.red_y,  found.green_x, found.green_y,
                             found.blue_x, found.blue_y, found.white_x, found.white_y};
    for (int i = 0; i < 8; i++)
        if (!(fabsf(values[i] - rec709[i]) <= tolerance))
            return brdf_fail(
                error, BRDF_UNSUPPORTED,
                "%s: its primaries are not those of Rec. 709 (red at %g, %g); convert it "
                "to linear Rec. 709 first",
                reader->source->path, (double)found.red_x, (double)found.red_y);
    return BRDF_OK;
}

brdf_status brdfcl_exr_read_header(struct exr_reader *reader, struct brdf_error *error)
{
    uint64_t chunk_bytes = 0;
    brdf_status status = find_part(reader, error);
    if (status == BRDF_OK)
        status = check_sampling(reader, error);
    if (status == BRDF_OK)
        status = check_primaries(reader, error);
    if (status != BRDF_OK)
        return status;
    exr_result_t code = exr_get_data_window(reader->context, reader->part, &reader->data);
    if (code == EXR_ERR_SUCCESS)
        code = exr_get_display_window(reader->context, reader->part, &reader->display);
    if (code == EXR_ERR_SUCCESS)
        code = exr_get_chunk_unpacked_size(reader->context, reader->part, &chunk_bytes);
    if (code != EXR_ERR_SUCCESS)
        return brdfcl_exr_fail(reader, code, error);
    const exr_attr_box2i_t *windows[] = {&reader->data, &reader->display};
    for (int i = 0; status == BRDF_OK && i < 2; i++)
        status = brdfcl_image_size_check(
            reader->source->path, (long long)windows[i]->max.x - windows[i]->min.x + 1,
            (long long)windows[i]->max.y - windows[i]->min.y + 1, error);
    /* OpenEXR 3.1 counts the bytes of a chunk in an int here and there. */
    if (status == BRDF_OK && chunk_bytes > INT_MAX)
        status =
            brdf_fail(error, BRDF_UNSUPPORTED, "%s: its tiles are too large", reader->source->path);
    return status;
}
