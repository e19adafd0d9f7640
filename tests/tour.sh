#!/bin/sh
# tour.sh - every command of docs/tour.md does what the page says, in an empty folder.
set -eu

page=$(pwd)/docs/tour.md
BRDFCL=${BRDFCL:-$(pwd)/${BUILD:-build}/brdfcl}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
mkdir bin
ln -s "$BRDFCL" bin/brdfcl
PATH="$work/bin:$PATH"
export PATH

awk '/^```xml/ { on = 1; next } /^```/ { on = 0 } on' "$page" >tour.xml
# Pictures in the small: the page is for eyes, this is not.
awk '/^```sh/ { on = 1; next } /^```/ { on = 0 } on' "$page" |
    sed 's/^brdfcl render .*/& --spp 2 --size 64x40 --backend c --quiet/' >commands
[ -s tour.xml ] && [ -s commands ]
sh -eux commands >log 2>&1 || { cat log; exit 1; }

for file in gold.binary paint.binary dull.binary red.binary half.binary; do
    [ "$(wc -c <$file)" -eq 34992012 ] || { echo "$file is not a MERL file"; exit 1; }
done
for file in before.png after.png tour.png tour.exr dull.png half.bsdf; do
    [ -s $file ] || { echo "$file was not made"; exit 1; }
done
grep -q '^bsdf\|roughconductor:' log || { cat log; exit 1; }
