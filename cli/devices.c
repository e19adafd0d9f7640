/* devices.c - brdfcl devices: which OpenCL devices there are. */
#include <stdio.h>

#include <brdfcl/device.h>

#include "commands.h"
#include "options.h"
#include "say.h"

static void show(int number, const struct brdfcl_device_info *info)
{
    const double gigabyte = 1024.0 * 1024.0 * 1024.0;
    printf("%d  %s%s\n", number, info->name, info->available ? "" : " (not available)");
    printf("   %s, %d cores, %d lanes, %.1f GiB (%.1f GiB in one buffer)\n",
           info->cpu ? "processor" : "accelerator", info->compute_units, info->native_lanes,
           (double)info->memory / gigabyte, (double)info->largest / gigabyte);
    printf("   %s; driver %s\n", info->platform_version, info->driver);
}

int command_devices(int argc, char **argv)
{
    const struct usage usage = {
        "devices",
        "",
        "List the OpenCL devices: number (for --device), name, cores, native lanes, memory.",
        NULL,
        0,
        0,
        0};
    struct texts arguments;
    int status = options_read(&usage, argc, argv, &arguments);
    if (status != OPTIONS_GO_ON) {
        return status;
    }
    int count = brdfcl_device_count();
    if (count == 0) {
        say("no OpenCL device found: install one (Debian: pocl-opencl-icd), or use --backend c");
        return EXIT_FAILED;
    }
    for (int i = 0; i < count; ++i) {
        struct brdfcl_device_info info;
        struct brdf_error error = {BRDF_OK, ""};
        if (brdfcl_device_describe(i, &info, &error)) {
            return say_error(&error);
        }
        show(i, &info);
    }
    return EXIT_DONE;
}
