#!/bin/sh
# lint.sh - the rules of the dialect that a C compiler lets pass.
#
#   tools/lint.sh [FILE...]
#
# The shared text is every kernel, every model, and whatever they include by a quoted name; headers of
# the host API may do as they like. PoCL would accept a double or a recursion without a word, and a
# sinf() from the platform gives other bits on every machine. Prints FILE:LINE: rule, exits with 1.
set -eu

awk_check='
# The line without comments and strings; in_comment lasts over lines.
function code_of(line,    out, start, end) {
    out = ""
    gsub(/\\\\/, "", line)
    gsub(/\\"/, "", line)
    gsub(/"[^"]*"/, "\"\"", line)
    while (line != "") {
        if (in_comment) {
            end = index(line, "*/")
            if (!end) return out
            line = substr(line, end + 2)
            in_comment = 0
        } else {
            start = index(line, "/*")
            end = index(line, "//")
            if (end && (!start || end < start)) return out substr(line, 1, end - 1)
            if (!start) return out line
            out = out substr(line, 1, start - 1) " "
            line = substr(line, start + 2)
            in_comment = 1
        }
    }
    return out
}
function word(pattern) {
    return code ~ ("(^|[^A-Za-z0-9_])(" pattern ")([^A-Za-z0-9_]|$)")
}
function call(pattern) {
    return code ~ ("(^|[^A-Za-z0-9_])(" pattern ")[ ]*\\(")
}
function broken(rule) {
    printf "%s:%d: %s\n", FILENAME, FNR, rule
    ++count
}
# A number with a point or an exponent, and no f after it.
function has_bare_literal(    rest, before, after) {
    rest = " " code
    gsub(/0[xX][0-9a-fA-F]+/, "0", rest)
    while (match(rest, /([0-9]+\.[0-9]*|\.[0-9]+|[0-9]+[eE])/)) {
        before = substr(rest, RSTART - 1, 1)
        rest = substr(rest, RSTART)
        match(rest, /^([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?/)
        after = substr(rest, RLENGTH + 1, 1)
        rest = " " substr(rest, RLENGTH + 1)
        if (before !~ /[A-Za-z0-9_.]/ && after !~ /[fF]/) return 1
    }
    return 0
}
FNR == 1 { in_comment = 0 }
{
    code = code_of($0)
    dialect = FILENAME ~ /dialect(_c|_opencl|_wide)?\.h$/
    if (word("double")) broken("no double")
    if (has_bare_literal()) broken("a floating literal ends in f")
    if (word("goto")) broken("no goto")
    kernel = FILENAME ~ /\.cl$/
    if (!dialect && code ~ /(^|[^A-Za-z0-9_])static[^A-Za-z0-9_]/ && code !~ /static (inline|__attribute__)/ &&
        !(kernel && code ~ /^static [^=[]*\(/)) broken("no static data; functions are static inline")
    if (word("bool|long") || (word("size_t") && !kernel)) broken("only int, unsigned and float")
    if (call("(sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|exp|exp2|expm1|log|log2|log10|log1p" \
             "|pow|erf|erfc|tgamma|lgamma|cbrt|hypot|fmod|remainder|ldexp|frexp|fma|fmin|fmax|fdim" \
             "|ceil|round|trunc|rint|nearbyint|copysign|sqrt|fabs|floor)l?") && !dialect)
        broken("a function of double, or of the platform: use math.h of ours, sqrtf, fabsf, floorf")
    if (call("(sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|exp|exp2|expm1|log|log2|log10|log1p" \
             "|pow|erf|erfc|tgamma|lgamma|cbrt|hypot|fmod|remainder|ldexp|frexp|fma|fmin|fmax|fdim" \
             "|ceil|round|trunc|rint|nearbyint|copysign)f"))
        broken("a function of the platform: use math.h of ours, brdf_min, brdf_max")
    if (call("(native|half)_[a-z0-9]+") ||
        call("mad|rsqrt|cross|dot|normalize|length|distance|mix|clamp|smoothstep|step|sign"))
        broken("OpenCL alone has this function: C cannot follow")
    if (!dialect && FILENAME ~ /^include/ && code ~ /__OPENCL|__kernel|__global|__constant|__local/)
        broken("of the shared headers, only dialect*.h ask which compiler reads it")
    if (!dialect && code ~ /#[ ]*include[ ]*</) broken("an angle include is for the host alone")
}
END { exit count > 0 }
'

# The files, and what they include by a quoted name, and so on; each once.
closure() {
    awk '
    function visit(path,    line, name, base) {
        if (path in seen || (getline line < path) < 0) return
        seen[path] = 1
        print path
        base = path
        sub(/[^\/]*$/, "", base)
        do {
            if (line !~ /^[ \t]*#[ \t]*include[ \t]*"/) continue
            name = line
            sub(/^[^"]*"/, "", name)
            sub(/".*$/, "", name)
            pending[++last] = base name
            pending[++last] = "include/" name
            pending[++last] = name
        } while ((getline line < path) > 0)
        close(path)
    }
    function tidy(path) {
        while (sub(/[^\/.]+\/\.\.\//, "", path)) { }
        return path
    }
    BEGIN {
        for (i = 1; i < ARGC; ++i) pending[++last] = ARGV[i]
        for (first = 1; first <= last; ++first) visit(tidy(pending[first]))
    }' "$@"
}

[ $# -gt 0 ] || set -- $(ls include/brdf/model.h include/brdf/model/*.h kernels/*.h kernels/*.cl \
    2>/dev/null | grep -v '[*]')
awk "$awk_check" $(closure "$@")
