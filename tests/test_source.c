/* test_source.c - the shared text put together: what is included how often, and that it compiles.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <brdf/source.h>

static const char *const guarded[] = {
    "/* a comment with #include \"no.h\" and \"quotes */",
    "#ifndef GUARDED_H",
    "#define GUARDED_H",
    "int guarded; /* #endif */",
    "#if 1",
    "#include \"../plain.h\"",
    "#endif",
    "#endif /* the",
    "          guard */",
    "",
    "int outside;",
    NULL,
};
static const char *const plain[] = {"int plain;", NULL};
static const char *const alternative[] = {
    "#ifndef A", "#define A", "int first;", "#else", "int again;", "#endif", NULL,
};
static const char *const circle[] = {"#include \"circle.h\"", NULL};
static const char *const wrong[] = {"", "", "this is not C;", NULL};
static const char *const lost[] = {"", "#include \"plian.h\"", NULL};

static const struct brdf_source_file files[] = {
    {"deep/guarded.h", guarded},
    {"plain.h", plain},
    {"alternative.h", alternative},
    {"circle.h", circle},
    {"wrong.h", wrong},
    {"deep/lost.h", lost},
    {NULL, NULL},
};

static void assert_expands(const char *text, const char *expected)
{
    char *out;
    struct brdf_error error;
    if (brdf_source_expand(text, "a.cl", files, &out, &error)) {
        fail_msg("%s", error.message);
    }
    assert_string_equal(out, expected);
    free(out);
}

static void includes_are_replaced(void **state)
{
    (void)state;
    assert_expands("", "");
    assert_expands("one\ntwo", "#line 1 \"a.cl\"\none\ntwo\n");
    assert_expands(
        "one\n#include \"plain.h\"\ntwo\n",
        "#line 1 \"a.cl\"\none\n#line 1 \"plain.h\"\nint plain;\n#line 3 \"a.cl\"\ntwo\n");
    assert_expands(" # include /* x */ \"./deep/../plain.h\" // y\n",
                   "#line 1 \"plain.h\"\nint plain;\n");
    assert_expands("#include <plain.h>\n", "#line 1 \"a.cl\"\n#include <plain.h>\n");
}

static void what_is_no_include_stays(void **state)
{
    (void)state;
    assert_expands("/*\n#include \"no.h\"\n*/\n", "#line 1 \"a.cl\"\n/*\n#include \"no.h\"\n*/\n");
    assert_expands("#define X \\\n#include \"no.h\"\n",
                   "#line 1 \"a.cl\"\n#define X \\\n#include \"no.h\"\n");
    assert_expands("\"/*\"\n#include \"plain.h\"\n",
                   "#line 1 \"a.cl\"\n\"/*\"\n#line 1 \"plain.h\"\nint plain;\n");
    assert_expands("'\\'' '\"' // /*\n#include \"plain.h\"\n",
                   "#line 1 \"a.cl\"\n'\\'' '\"' // /*\n#line 1 \"plain.h\"\nint plain;\n");
}

static void guards_are_passed_once(void **state)
{
    (void)state;
    char *out;
    const char *text = "#include \"deep/guarded.h\"\n#include \"deep/guarded.h\"\n"
                       "#include \"deep/guarded.h\"\nend\n";
    assert_int_equal(brdf_source_expand(text, "a.cl", files, &out, NULL), BRDF_OK);
    const char *second = strstr(out, "int outside;");
    assert_non_null(strstr(out, "int guarded;"));
    assert_non_null(strstr(out, "#line 1 \"plain.h\"\nint plain;\n#line 7 \"deep/guarded.h\"\n"));
    assert_string_equal(second,
                        "int outside;\n#line 11 \"deep/guarded.h\"\nint outside;\n"
                        "#line 11 \"deep/guarded.h\"\nint outside;\n#line 4 \"a.cl\"\nend\n");
    free(out);
    /* With an #else it is no include guard: the whole text every time. */
    text = "#include \"alternative.h\"\n#include \"alternative.h\"\n";
    assert_int_equal(brdf_source_expand(text, "a.cl", files, &out, NULL), BRDF_OK);
    assert_non_null(strstr(strstr(out, "int first;") + 1, "int first;"));
    free(out);
}

static void names_with_quotes_are_escaped(void **state)
{
    (void)state;
    char *out;
    assert_int_equal(brdf_source_expand("x\n", "C:\\a \"b\".cl", NULL, &out, NULL), BRDF_OK);
    assert_string_equal(out, "#line 1 \"C:\\\\a \\\"b\\\".cl\"\nx\n");
    free(out);
}

static void bad_includes_are_refused(void **state)
{
    (void)state;
    const struct {
        const char *text;
        brdf_status status;
        const char *word;
    } bad[] = {
        {"\n#include \"no.h\"\n", BRDF_UNKNOWN_NAME, "a.cl:2: there is no \"no.h\""},
        {"#include \"deep/lost.h\"\n", BRDF_UNKNOWN_NAME, "deep/lost.h:2: there is no \"plian.h\""},
        {"#include \"deep/lost.h\"\n", BRDF_UNKNOWN_NAME, "did you mean \"plain.h\""},
        {"#include \"../../plain.h\"\n", BRDF_UNKNOWN_NAME, "../../plain.h"},
        {"#include \"brdf/model/difuse.h\"\n", BRDF_UNKNOWN_NAME, "\"brdf/model/diffuse.h\""},
        {"#include \"circle.h\"\n", BRDF_BAD_ARGUMENT, "circle.h:1"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i) {
        struct brdf_error error = {0};
        char *out = (char *)&error;
        assert_int_equal(brdf_source_expand(bad[i].text, "a.cl", files, &out, &error),
                         bad[i].status);
        assert_null(out);
        if (!strstr(error.message, bad[i].word)) {
            fail_msg("\"%s\" does not say \"%s\"", error.message, bad[i].word);
        }
    }
}

static void headers_are_carried(void **state)
{
    (void)state;
    int models = 0;
    for (int i = 0; brdf_source_name(i); ++i) {
        assert_non_null(brdf_source_lines(brdf_source_name(i)));
        models += strncmp(brdf_source_name(i), "brdf/model/", 11) == 0;
    }
    assert_true(models >= 5);
    assert_null(brdf_source_lines("brdf/none.h"));
    assert_null(brdf_source_name(-1));
}

/* Build for the first device there is; the log is for the reader of a failure. */
static int build(cl_device_id device, const char *text, const char *options, char *log, size_t size)
{
    cl_int status;
    cl_context context = clCreateContext(NULL, 1, &device, NULL, NULL, &status);
    assert_int_equal(status, CL_SUCCESS);
    cl_program program = clCreateProgramWithSource(context, 1, &text, NULL, &status);
    assert_int_equal(status, CL_SUCCESS);
    status = clBuildProgram(program, 1, &device, options, NULL, NULL);
    memset(log, 0, size);
    clGetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_LOG, size - 1, log, NULL);
    clReleaseProgram(program);
    clReleaseContext(context);
    return status;
}

static cl_device_id first_device(void)
{
    cl_platform_id platform;
    cl_device_id device = NULL;
    if (clGetPlatformIDs(1, &platform, NULL) == CL_SUCCESS) {
        clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, 1, &device, NULL);
    }
    return device;
}

static void opencl_compiles_it_at_every_lane_count(void **state)
{
    (void)state;
    static const int lanes[] = {1, 4, 8, 16, 32};
    static char log[65536];
    cl_device_id device = first_device();
    char *out;
    if (!device) {
        skip();
    }
    /* model.h twice, directly and not: its guard must hold and its list must not suffer. */
    const char *text = "#include \"brdf/model.h\"\n#include \"brdf/surface.h\"\n"
                       "#include \"brdf/model/diffuse.h\"\n"
                       "kernel void f(global float *x) { x[0] = BRDF_MODEL_COUNT + BRDF_LANES; }\n";
    assert_int_equal(brdf_source_expand(text, "a.cl", NULL, &out, NULL), BRDF_OK);
    for (int i = 0; i < 5; ++i) {
        char options[64];
        snprintf(options, sizeof options, "-cl-std=CL1.2 -Werror -DBRDF_LANES=%d", lanes[i]);
        if (build(device, out, options, log, sizeof log) != CL_SUCCESS) {
            fail_msg("%s: %s", options, log);
        }
    }
    free(out);
}

static void opencl_names_the_real_file(void **state)
{
    (void)state;
    static char log[65536];
    cl_device_id device = first_device();
    char *out;
    if (!device) {
        skip();
    }
    const char *text = "#include \"brdf/vec.h\"\n#include \"wrong.h\"\n";
    assert_int_equal(brdf_source_expand(text, "a.cl", files, &out, NULL), BRDF_OK);
    assert_int_not_equal(build(device, out, "-cl-std=CL1.2", log, sizeof log), CL_SUCCESS);
    if (!strstr(log, "wrong.h:3")) {
        fail_msg("the log does not name wrong.h:3: %s", log);
    }
    free(out);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(includes_are_replaced),
        cmocka_unit_test(what_is_no_include_stays),
        cmocka_unit_test(guards_are_passed_once),
        cmocka_unit_test(names_with_quotes_are_escaped),
        cmocka_unit_test(bad_includes_are_refused),
        cmocka_unit_test(headers_are_carried),
        cmocka_unit_test(opencl_compiles_it_at_every_lane_count),
        cmocka_unit_test(opencl_names_the_real_file),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
