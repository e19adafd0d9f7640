#!/bin/sh
# add_model.sh - one file and one line in models.h are a new model.
#
# In a copy of the tree, with the objects that are already built: adds a model and nothing else,
# builds, and asks the generic tests for it: values, energy, sampling, OpenCL's bits, and the command.
# A second model that lies about its density, its energy and its reciprocity must be found out.
set -eu

BUILD=${BUILD:-build}
MAKE=${MAKE:-make}
if [ -n "${SANITIZE:-}" ]; then
    echo "skipped: the sanitizers learn nothing from it that they do not learn from other models"
    exit 77
fi
tree=$(mktemp -d "${TMPDIR:-/tmp}/brdfcl-add-model.XXXXXX")
trap 'rm -rf "$tree"' EXIT
trap 'exit 1' HUP INT TERM

# Times are kept, so that only what knows about models is built again.
cp -pR Makefile include kernels lib cli bench tests tools "$tree" 2>/dev/null || true
mkdir "$tree/build"
cp -pR "$BUILD/obj" "$tree/build/" 2>/dev/null || true
cd "$tree"

cat >include/brdf/model/dummy.h <<'EOF'
/*
 * dummy - a test: a flat or a rounded lobe, sampled without any skill.
 */
#ifndef BRDF_MODEL_DUMMY_H
#define BRDF_MODEL_DUMMY_H

#include "../parameters.h"
#include "../sample.h"
#include "../warp.h"

#define BRDF_DUMMY_PARAMETERS(P)                                                                   \
    P(CHOICE, shape, 0, 0, 1, "flat|round", "form of the lobe")                                    \
    P(REAL, strength, 0.5f, 0.0f, 1.0f, "1", "factor of all of it")                                \
    P(COLOR, tint, 0.8f, 0.0f, 1.0f, "1", "its colour")

struct brdf_dummy {
    BRDF_DUMMY_PARAMETERS(BRDF_FIELD)
};

static inline brdf_rgb brdf_dummy_eval(struct brdf_dummy p, brdf_vec3 wo, brdf_vec3 wi,
                                       BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    brdf_real f = BRDF_1_PI * p.strength;
    if (p.shape == 1) {
        f = f * (wo.z * wi.z);
    }
    return brdf_rgb_scale(p.tint, brdf_pick(above, f, 0.0f));
}

static inline brdf_real brdf_dummy_pdf(struct brdf_dummy p, brdf_vec3 wo, brdf_vec3 wi,
                                       BRDF_GLOBAL const float *table)
{
    (void)p;
    (void)table;
    return brdf_pick((wo.z > 0.0f) & (wi.z > 0.0f), 0.5f * BRDF_1_PI, 0.0f);
}

static inline struct brdf_sample brdf_dummy_sample(struct brdf_dummy p, brdf_vec3 wo, brdf_vec3 u,
                                                   BRDF_GLOBAL const float *table)
{
    brdf_vec3 wi = brdf_warp_sphere(0.5f * u.x, u.y);
    brdf_rgb f = brdf_dummy_eval(p, wo, wi, table);
    brdf_rgb weight = brdf_rgb_scale(f, wi.z * BRDF_TWO_PI);
    brdf_mask valid = (wo.z > 0.0f) & (wi.z > 0.0f);
    return brdf_sample_where(valid, brdf_sample_make(wi, weight, 0.5f * BRDF_1_PI));
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(dummy, DUMMY, BRDF_REFLECTION | BRDF_RECIPROCAL, "a test", "nobody")
#endif
EOF
sed -e 's/dummy/liar/g' -e 's/DUMMY/LIAR/g' \
    -e 's/f = f \* (wo.z \* wi.z)/f = f * (4.0f + wo.z)/' \
    -e 's/0.5f \* BRDF_1_PI/0.4f * BRDF_1_PI/' -e 's/brdf_warp_sphere(0.5f \* u.x, u.y)/brdf_warp_sphere(0.45f * u.x, u.y)/' \
    include/brdf/model/dummy.h >include/brdf/model/liar.h
for model in dummy liar; do
    echo "#include \"model/$model.h\"" >>include/brdf/models.h
done

tests='test_models_values test_models_energy test_models_sampling test_models_opencl'
programs=
for test in $tests; do
    programs="$programs build/tests/$test"
done
if [ -f cli/main.c ]; then
    programs="$programs build/brdfcl"
fi
# shellcheck disable=SC2086 # a list
"$MAKE" --no-print-directory BUILD=build CFLAGS=-O1 -j"${JOBS:-2}" $programs

for test in $tests; do
    BRDFCL_TEST_MODEL=dummy build/tests/"$test" >log 2>&1 || {
        cat log
        exit 1
    }
    # It must have been there to be tested, not just have broken nothing.
    grep -q '^\[       OK \] dummy: \|^\[  SKIPPED \] dummy: ' log || {
        cat log
        echo "$test does not know the new model"
        exit 1
    }
done
if [ -x build/brdfcl ]; then
    build/brdfcl models dummy | grep -q strength
    build/brdfcl models | grep -q dummy
    build/brdfcl test dummy:shape=round --samples 100000 --calls 10000 >log || {
        cat log
        exit 1
    }
    if build/brdfcl test liar:shape=round --samples 100000 --calls 10000 >log; then
        echo "the lies of a model were not found"
        exit 1
    fi
    for lie in reciprocal 'weight = f cos / pdf' 'mass of pdf' 'chi-square' energy 'albedo by both ways'; do
        grep -q "^$lie .* FAIL" log || {
            cat log
            echo "a lie was not found: $lie"
            exit 1
        }
    done
fi
echo "one file and one line: $(grep -c . include/brdf/model/dummy.h) lines"
