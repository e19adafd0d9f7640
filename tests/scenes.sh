#!/bin/sh
# scenes.sh - every scene that comes with the project loads and renders, small, without a word and
# without a NaN.
set -eu

scenes=$(pwd)/scenes
. "$(dirname "$0")/support_cli"

made='one.exr one.json'
for scene in "$scenes"/*.xml "$scenes"/gallery/*.xml; do
    last="render $scene"
    expect 0 render "$scene" --backend c --size 16x9 --spp 1 --quiet -o one.exr --json one.json
    holds "warnings: $scene" [ ! -s err ]
    # The mean of all pixels is NaN if one is, and JSON has no NaN.
    mean=$(tr -d ' \n' <one.json | sed -n 's/.*"mean":\[\([^]]*\)\].*/\1/p')
    holds "$scene: mean $mean" awk -v mean="$mean" 'BEGIN {
        n = split(mean, c, ","); sum = 0
        for (i = 1; i <= n; ++i) { if (c[i] !~ /^[0-9][0-9.e+-]*$/) exit 1; sum += c[i] }
        exit !(n == 3 && sum > 0)
    }'
    empty
done
holds 'scenes were found' [ "$checks" -gt 60 ]

finish
