#!/bin/sh
# cli_files.sh - results are whole files or none: behind symbolic links, under long names, and where a
# signal comes while they are made.
set -eu

. "$(dirname "$0")/support_cli"

# --- symbolic links --------------------------------------------------------------------------------

# through NAME ARGUMENT...: what is written through a link to NAME is in NAME, which keeps its mode.
through() {
    file=$1
    shift
    last="$* through a link"
    echo old >"$file"
    chmod 640 "$file"
    mkdir links
    ln -s "../$file" "links/$file"
    expect 0 "$@" "links/$file"
    holds "$file: the link was replaced" [ -L "links/$file" ]
    holds "$file: not written" [ "$(head -c 3 "$file")" != old ]
    holds "$file: another mode" [ "$(ls -l "$file" | cut -c 1-10)" = -rw-r----- ]
    rm -r links "$file"
}
through a.binary convert diffuse
through a.bsdf convert diffuse --thetas 3 --size 4
through a.svg plot diffuse --panels lobe -o
through a.json albedo diffuse --samples 1024 --json
empty

ln -s nothing a.binary
made=a.binary
refused 1 'leads nowhere' convert diffuse a.binary
rm a.binary
ln -s nothing a.json
made='a.json nothing'
last='albedo --json to a link that leads nowhere'
expect 0 albedo diffuse --samples 1024 --json a.json
holds 'the link was replaced' [ -L a.json ]
holds 'not valid JSON' valid_json nothing
rm a.json nothing

# A name that has no room for a suffix of a temporary file's.
long=$(printf '%0250d' 0).json
long=$(echo "$long" | tail -c 251)
made=$long
last='albedo --json to a long name'
expect 0 albedo diffuse --samples 1024 --json "$long"
holds 'not valid JSON' valid_json "$long"
rm "$long"
made=

# --- signals ---------------------------------------------------------------------------------------

# stopped SIGNAL STATUS ARGUMENT...: after a signal in the middle there is nothing.
stopped() {
    signal=$1 wanted=$2
    shift 2
    last="$* and SIG$signal"
    "$BRDFCL" "$@" >out 2>err </dev/null &
    process=$!
    sleep 0.3
    kill -"$signal" "$process" || fail "over before it could be stopped: $last"
    status=0
    wait "$process" 2>/dev/null || status=$?
    holds "status $status, not $wanted" [ "$status" -eq "$wanted" ]
    empty
}
# SIGTERM: a shell without job control starts what is in the background with SIGINT ignored.
stopped TERM 143 plot principled wood roughplastic --scale 8 -o a.png
stopped TERM 143 plot principled wood roughplastic --scale 8 -o a.svg
stopped TERM 143 convert wood a.bsdf --size 128 --thetas 64
stopped TERM 143 fit wood --model ward --starts 1000 -o a.png
stopped TERM 143 test wood --json a.json

finish
