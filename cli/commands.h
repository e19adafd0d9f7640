/*
 * commands.h - the subcommands: each takes its arguments (without its own name) and returns the
 * exit status of the program.
 */
#ifndef BRDFCL_COMMANDS_H
#define BRDFCL_COMMANDS_H

enum exit_status {
    EXIT_DONE = 0,
    EXIT_FAILED = 1, /* it was understood, tried, and did not succeed */
    EXIT_USAGE = 2   /* it was not understood */
};

int command_render(int argc, char **argv);
int command_models(int argc, char **argv);
int command_devices(int argc, char **argv);
int command_eval(int argc, char **argv);
int command_plot(int argc, char **argv);
int command_sample(int argc, char **argv);
int command_albedo(int argc, char **argv);
int command_navigate(int argc, char **argv);
int command_fit(int argc, char **argv);
int command_test(int argc, char **argv);
int command_check(int argc, char **argv);
int command_info(int argc, char **argv);
int command_convert(int argc, char **argv);
int command_edit(int argc, char **argv);
int command_mix(int argc, char **argv);
int command_bench(int argc, char **argv);

#endif
