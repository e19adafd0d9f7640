#!/bin/sh
# cli_plot.sh - brdfcl plot: pictures that are what they say, the same each time, whole or not at all.
set -eu

. "$(dirname "$0")/support_cli"
made='a.png b.png a.svg b.svg'

# Width and height of a PNG, in its IHDR chunk.
png_size() {
    od -An -tu1 -j16 -N8 "$1" |
        awk '{ print (($1 * 256 + $2) * 256 + $3) * 256 + $4 "x" (($5 * 256 + $6) * 256 + $7) * 256 + $8 }'
}
well_formed() {
    if command -v python3 >/dev/null; then
        python3 -c 'import sys, xml.dom.minidom; xml.dom.minidom.parse(sys.argv[1])' "$1"
    else
        grep -q '</svg>' "$1"
    fi
}

# Every panel, of a material that reflects, one that lets light through and one that is a mirror.
last='plot -o a.png'
expect 0 plot ward:alpha_u=0.1,alpha_v=0.4 roughdielectric conductor plastic --scale 0.5 -o a.png
holds 'not a PNG' magic a.png 89504e47
expect 0 plot ward:alpha_u=0.1,alpha_v=0.4 roughdielectric conductor plastic --scale 0.5 -o b.png
holds 'the same call, another picture' cmp -s a.png b.png

last='plot -o a.svg'
expect 0 plot plastic --panels lobe,slice,albedo --title 'Less < & more' -o a.svg
holds 'not well-formed' well_formed a.svg
holds 'no SVG' grep -q '<svg ' a.svg
expect 0 plot plastic --panels lobe,slice,albedo --title 'Less < & more' -o b.svg
holds 'the same call, another picture' cmp -s a.svg b.svg
expect 0 plot plastic --panels lobe,slice,albedo --title 'Less < & more' --log -o b.svg
holds '--log changes nothing' [ "$(cksum <a.svg)" != "$(cksum <b.svg)" ]
for change in '--dark' '--angles 10' '--phi 30' '--channel red' '--panels lobe'; do
    expect 0 plot ward:alpha_u=0.1,alpha_v=0.4,diffuse_reflectance=0.5/0.1/0.1 --panels lobe,slice \
        -o a.svg
    expect 0 plot ward:alpha_u=0.1,alpha_v=0.4,diffuse_reflectance=0.5/0.1/0.1 --panels lobe,slice \
        $change -o b.svg
    holds "$change changes nothing" [ "$(cksum <a.svg)" != "$(cksum <b.svg)" ]
done

# The size that was asked for, in pixels and in points.
expect 0 plot diffuse --panels lobe --size 640x480 -o a.png
holds 'not 640x480' [ "$(png_size a.png)" = 640x480 ]
expect 0 plot diffuse --panels lobe --size 640x480 -o a.svg
holds 'not 640x480' grep -q 'viewBox="0 0 640 480"' a.svg
rm a.png b.png a.svg b.svg

# What is wrong is said, and nothing is left.
refused 2 'needs -o FILE' plot diffuse
refused 2 'an argument is missing' plot -o a.png
refused 1 '\.png or a \.svg' plot diffuse -o a.pdf
refused 1 "did you mean .diffuse." plot difuse -o a.png
refused 1 'nonexistent' plot diffuse -o nonexistent/a.png
refused 2 'did you mean "sphere"' plot diffuse --panels spere -o a.png
refused 2 'twice' plot diffuse --panels lobe,lobe -o a.png
refused 1 'from 0 to 89.9' plot diffuse --angles 90 -o a.png
refused 2 'too many' plot diffuse --angles 1,2,3,4,5,6,7,8,9 -o a.png
refused 1 'no room' plot diffuse --size 100x100 -o a.png
refused 2 'one argument too many' plot diffuse diffuse diffuse diffuse diffuse diffuse diffuse \
    diffuse diffuse -o a.png

# A file that was there survives what fails.
echo precious >a.png
made=a.png
last='plot into a full disk'
expect 1 plot diffuse --size 100x100 -o a.png
holds 'an old file was touched' [ "$(cat a.png)" = precious ]
rm a.png

finish
