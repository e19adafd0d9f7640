/*
 * main.c - brdfcl: finds the subcommand and runs it.
 */
#define _XOPEN_SOURCE 700 /* SIGXFSZ */
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

#include <brdf/info.h>

#include "commands.h"
#include "say.h"
#include "stop.h"

static const struct command {
    const char *name;
    int (*run)(int argc, char **argv);
    const char *summary;
} commands[] = {
    {"render", command_render, "render a scene to OpenEXR and PNG"},
    {"models", command_models, "list the models, or the parameters of one"},
    {"devices", command_devices, "list the OpenCL devices"},
    {"eval", command_eval, "evaluate a material for two directions"},
    {"plot", command_plot, "draw lobes, slices, albedos and spheres of materials"},
    {"sample", command_sample, "draw directions from a material, as CSV"},
    {"albedo", command_albedo, "how much light a material reflects and transmits"},
    {"info", command_info, "describe a measured file, and where it is to be doubted"},
    {"convert", command_convert, "write a material as a measured file"},
    {"edit", command_edit, "change the gloss or colour of a measured material"},
    {"mix", command_mix, "mix measured materials into a new one"},
    {"navigate", command_navigate, "map measured materials, and make new ones between them"},
    {"fit", command_fit, "find a model's parameters that come nearest to a material"},
    {"test", command_test, "statistical tests of a material, or of every model"},
    {"check", command_check, "compare C with OpenCL, bit by bit"},
    {"bench", command_bench, "measure C against OpenCL"},
};

enum { COMMANDS = sizeof commands / sizeof commands[0] };

static void help(FILE *file)
{
    fputs("usage: brdfcl COMMAND [arguments] [options]\n\n", file);
    for (int i = 0; i < COMMANDS; ++i) {
        fprintf(file, "  %-10s %s\n", commands[i].name, commands[i].summary);
    }
    fputs("\n\"brdfcl COMMAND --help\" says more; \"brdfcl --version\" says which this is.\n"
          "Exit status: 0 done, 1 failed, 2 the command line is not valid.\n",
          file);
}

static int unknown_command(const char *name)
{
    const char *names[COMMANDS];
    for (int i = 0; i < COMMANDS; ++i) {
        names[i] = commands[i].name;
    }
    return say_usage("unknown command \"%s\"%s; \"brdfcl --help\" lists them", name,
                     say_nearest(brdf_name_nearest(name, names, COMMANDS)).text);
}

static int run(int argc, char **argv)
{
    if (argc < 2) {
        help(stderr);
        return EXIT_USAGE;
    }
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0) {
        help(stdout);
        return EXIT_DONE;
    }
    if (strcmp(argv[1], "--version") == 0) {
        printf("brdfcl %s\n", BRDFCL_VERSION);
        return EXIT_DONE;
    }
    for (int i = 0; i < COMMANDS; ++i) {
        if (strcmp(argv[1], commands[i].name) == 0) {
            return commands[i].run(argc - 2, argv + 2);
        }
    }
    return unknown_command(argv[1]);
}

int main(int argc, char **argv)
{
    signal(SIGXFSZ, SIG_IGN); /* a limit on the size of files is an error like a full disk */
    int status = run(argc, argv);
    /* A result that did not reach its file is no result: a full disk shows only now. */
    if (fflush(stdout) || ferror(stdout)) {
        say("standard output: %s", strerror(errno));
        return status == EXIT_DONE ? EXIT_FAILED : status;
    }
    /* A signal that had to wait until a file was whole. */
    return status == EXIT_DONE && stop_signal() ? 128 + stop_signal() : status;
}
