/* stop.c - Ctrl-C while there is something to save. */
#define _POSIX_C_SOURCE 200809L
#include "stop.h"

#include <signal.h>
#include <string.h>
#include <unistd.h>

/* The one thing that a signal handler can reach is what is global. */
static volatile sig_atomic_t first_signal;
static volatile sig_atomic_t current_phase;
static sig_atomic_t phase_before; /* stop_wait; the handler does not look at it */

static void on_signal(int number)
{
    if (current_phase == STOP_QUITS || (current_phase == STOP_ASKS && first_signal)) {
        _exit(128 + number);
    }
    if (!first_signal) {
        first_signal = number;
    }
}

void stop_install(void)
{
    struct sigaction action, former;
    memset(&action, 0, sizeof action);
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART; /* files being read or written are not to fail for it */
    sigemptyset(&action.sa_mask);
    /* A shell script's "brdfcl ... &" ignores SIGINT from birth; who sends it then, means it. */
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    if (sigaction(SIGHUP, NULL, &former) == 0 && former.sa_handler != SIG_IGN) { /* nohup */
        sigaction(SIGHUP, &action, NULL);
    }
}

void stop_set_phase(enum stop_phase phase)
{
    current_phase = (sig_atomic_t)phase;
}

void stop_wait(void)
{
    phase_before = current_phase;
    current_phase = STOP_WAITS; /* first: with the handler comes no moment of another phase */
    stop_install();
}

void stop_resume(void)
{
    current_phase = phase_before;
}

int stop_signal(void)
{
    return first_signal;
}
