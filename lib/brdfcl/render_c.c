/*
 * render_c.c - the reference renderer: the stages, called one after another by plain loops.
 *
 * Each thread has its own pool of paths, small enough for its cache, and takes passes in turn. The
 * calling thread only watches, so that progress is reported from it.
 */
#define _POSIX_C_SOURCE 200809L
#include <pthread.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

#include "render_job.h"

#include "kernels/connect.h"
#include "kernels/film.h"
#include "kernels/generate.h"
#include "kernels/resolve.h"
#include "kernels/shade.h"
#include "kernels/sort.h"
#include "kernels/through.h"

#define MAX_THREADS 1024

struct crew {
    struct render_job *job;
    pthread_mutex_t lock; /* guards all below and the job */
    pthread_cond_t changed;
    int running; /* passes being worked on */
    int threads; /* that have not finished */
    int stop;
};

struct worker {
    struct crew *crew;
    float *state;
    pthread_t thread;
};

static void shade_all(struct pt_world w, const struct world *world, struct pt_pass pass, int depth)
{
    const struct pt_settings *settings = w.settings;
    int missed = settings->variant_count - 1;
    for (int v = 0; v < settings->variant_count; ++v) {
        const struct world_variant *from = &world->variants[v];
        struct pt_variant variant = {from->model,    from->flags,  from->choices, v,
                                     from->textured, from->colors, from->tilt};
        int first = w.queues[settings->variant_first + v];
        for (int i = 0; i < w.queues[PT_VARIANTS + v]; ++i) {
            if (v == missed) {
                pt_shade_missed(w, first + i);
            } else if (from->through) {
                pt_shade_through(w, pass, first + i, depth);
            } else {
                pt_shade(w, pass, variant, first + i, depth);
            }
        }
    }
}

/* All paths of a pass from the camera to their end. */
static void trace(struct pt_world w, const struct world *world, struct pt_pass pass)
{
    const struct pt_settings *settings = w.settings;
    int hierarchy = (settings->features & PT_HAS_BVH) != 0;
    pt_begin(w, pass);
    for (int i = 0; i < pass.path_count; ++i) {
        pt_generate(w, pass, i);
    }
    for (int depth = 0; depth < settings->max_depth; ++depth) {
        int active = w.queues[PT_ACTIVE + (depth & 1)];
        if (active == 0) {
            break;
        }
        pt_open_bounce(w, depth);
        for (int i = 0; i < active; ++i) {
            if (hierarchy) {
                pt_extend_ray(w, i, depth);
            } else {
                pt_extend_packet(w, i, depth);
            }
        }
        for (int i = 0; i < active && settings->fork_count > 0; ++i) {
            pt_resolve(w, pass, i, depth);
        }
        for (int block = 0; block < world->sort_blocks; ++block) {
            pt_sort(w, block, depth);
        }
        shade_all(w, world, pass, depth);
        for (int i = 0; i < w.queues[PT_SHADOWS]; ++i) {
            if (hierarchy) {
                pt_connect_ray(w, i);
            } else {
                pt_connect_packet(w, i);
            }
        }
        w.queues[PT_RAYS] += w.queues[PT_SHADOWS];
    }
}

/* The next pass for a thread; waits for a sweep to end before the next begins, as two passes must
   not add to the same pixel at once. 0 where there is nothing left to do. */
static int take_pass(struct crew *crew, struct pt_pass *pass)
{
    int taken = 0;
    pthread_mutex_lock(&crew->lock);
    for (;;) {
        if (crew->stop) {
            break;
        }
        taken = render_next_pass(crew->job, crew->running == 0, pass);
        if (taken || crew->running == 0) {
            break;
        }
        pthread_cond_wait(&crew->changed, &crew->lock);
    }
    crew->running += taken;
    pthread_mutex_unlock(&crew->lock);
    return taken;
}

static void *work(void *argument)
{
    struct worker *worker = argument;
    struct crew *crew = worker->crew;
    const struct world *world = &crew->job->world;
    struct pt_world w = pt_world_make(&world->settings, world->scene, world->tables, worker->state);
    world_variant_first(world, 1, w.queues + world->settings.variant_first);
    struct pt_pass pass;
    while (take_pass(crew, &pass)) {
        unsigned rays = (unsigned)w.queues[PT_RAYS];
        unsigned invalid = (unsigned)w.queues[PT_INVALID];
        trace(w, world, pass);
        for (int i = 0; i < pass.path_count >> pass.sample_bits; ++i) {
            pt_film(w, pass, crew->job->film, i);
        }
        pthread_mutex_lock(&crew->lock);
        render_count(crew->job, pass.path_count, (unsigned)w.queues[PT_RAYS] - rays,
                     (unsigned)w.queues[PT_INVALID] - invalid);
        crew->running -= 1;
        pthread_cond_broadcast(&crew->changed);
        pthread_mutex_unlock(&crew->lock);
    }
    pthread_mutex_lock(&crew->lock);
    crew->threads -= 1;
    pthread_cond_broadcast(&crew->changed);
    pthread_mutex_unlock(&crew->lock);
    return NULL;
}

/* Wait for all threads, and report now and then. */
static void watch(struct crew *crew)
{
    pthread_mutex_lock(&crew->lock);
    while (crew->threads > 0) {
        struct timespec until;
        clock_gettime(CLOCK_REALTIME, &until);
        until.tv_nsec += 100000000;
        if (until.tv_nsec >= 1000000000) {
            until.tv_nsec -= 1000000000;
            until.tv_sec += 1;
        }
        pthread_cond_timedwait(&crew->changed, &crew->lock, &until);
        if (!crew->stop && render_report(crew->job)) {
            crew->stop = 1;
            crew->job->result->stopped = 1;
            pthread_cond_broadcast(&crew->changed);
        }
    }
    pthread_mutex_unlock(&crew->lock);
}

static int thread_count(const struct brdfcl_render_options *options)
{
    long count = options->threads > 0 ? options->threads : sysconf(_SC_NPROCESSORS_ONLN);
    return count < 1 ? 1 : count > MAX_THREADS ? MAX_THREADS : (int)count;
}

brdf_status render_c(struct render_job *job, struct brdf_error *error)
{
    int count = thread_count(job->options);
    brdf_status status = BRDF_OK;
    struct crew crew = {job, PTHREAD_MUTEX_INITIALIZER, PTHREAD_COND_INITIALIZER, 0, 0, 0};
    struct worker *workers = calloc((size_t)count, sizeof *workers);
    job->started = render_now();
    job->reported = job->started;
    pthread_mutex_lock(&crew.lock);
    int started = 0;
    while (workers && started < count) {
        struct worker *worker = &workers[started];
        worker->crew = &crew;
        worker->state = world_allocate(job->world.state_words * sizeof(float));
        if (!worker->state || pthread_create(&worker->thread, NULL, work, worker) != 0) {
            free(worker->state);
            break;
        }
        ++started;
    }
    crew.threads = started;
    pthread_mutex_unlock(&crew.lock);
    watch(&crew);
    for (int i = 0; i < started; ++i) {
        pthread_join(workers[i].thread, NULL);
        free(workers[i].state);
    }
    if (started == 0) {
        status = brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory for %zu MB of paths",
                           job->world.state_words * sizeof(float) >> 20);
    }
    free(workers);
    pthread_mutex_destroy(&crew.lock);
    pthread_cond_destroy(&crew.changed);
    return status;
}
