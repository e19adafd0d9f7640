/*
 * finding.c - verdicts, and worst cases in words.
 */
#include "finding.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

struct lab_finding lab_finding_make(enum lab_test test, double angle, double limit)
{
    struct lab_finding finding;
    memset(&finding, 0, sizeof finding);
    finding.test = (int)test;
    finding.angle = angle;
    finding.limit = limit;
    return finding;
}

void lab_finding_judge(struct lab_finding *finding)
{
    int good = finding->at_least ? finding->measured >= finding->limit
                                 : finding->measured <= finding->limit;
    finding->verdict = good ? LAB_PASS : LAB_FAIL;
}

void lab_finding_set(struct lab_finding *finding, enum lab_verdict verdict, const char *reason)
{
    finding->verdict = (int)verdict;
    if (verdict == LAB_NONE) {
        finding->measured = (double)NAN;
    }
    snprintf(finding->detail, sizeof finding->detail, "%s", reason);
}

void lab_finding_note(struct lab_finding *finding, brdf_vec3 wo, brdf_vec3 wi, const brdf_vec3 *u)
{
    int used = snprintf(finding->where, sizeof finding->where,
                        "wo %.9g/%.9g/%.9g wi %.9g/%.9g/%.9g", (double)wo.x, (double)wo.y,
                        (double)wo.z, (double)wi.x, (double)wi.y, (double)wi.z);
    if (u && used > 0 && (size_t)used < sizeof finding->where) {
        snprintf(finding->where + used, sizeof finding->where - (size_t)used, " u %.9g/%.9g/%.9g",
                 (double)u->x, (double)u->y, (double)u->z);
    }
}

const char *lab_test_name(int test)
{
    static const char *const names[LAB_TEST_COUNT] = {
        "finite and not negative", "reciprocal",  "isotropic", "weight = f cos / pdf", "energy",
        "albedo by both ways",     "mass of pdf", "chi-square"};
    return test >= 0 && test < LAB_TEST_COUNT ? names[test] : "?";
}

const char *lab_verdict_name(int verdict)
{
    static const char *const names[] = {"pass", "FAIL", "open", "-", "note"};
    return verdict >= LAB_PASS && verdict <= LAB_NOTE ? names[verdict] : "?";
}
