#!/bin/sh
# make_gallery.sh - render the figures of scenes/gallery, and write a page that shows them.
#
#   tools/make_gallery.sh OUT           as large as the scenes say, into the folder OUT: index.html
#   tools/make_gallery.sh --docs OUT    small, for docs/gallery.md, which is written too
#
# A scene begins with a comment: its first line is the title, the others what is to be seen.
# BRDFCL is the command (build/brdfcl if not set).
set -eu
cd "$(dirname "$0")/.."

BRDFCL=${BRDFCL:-build/brdfcl}
docs=
[ "${1:-}" != --docs ] || { docs=yes && shift; }
[ $# -eq 1 ] || { sed -n '2,9s/^# \{0,1\}//p' "$0" >&2 && exit 2; }
out=$1
mkdir -p "$out"

# The lecture's order.
figures="conductors_and_dielectrics halfway_vector_and_mirror_direction ward \
copper_coloured_plastic_and_copper ggx_and_beckmann energy_loss_conductor \
energy_loss_conductor_compensated energy_loss_dielectric energy_loss_dielectric_compensated \
anisotropic_reflection brdf_of_the_moon surface_roughness_causes_flat_appearance \
naive_blend_and_smooth_plastic smooth_and_rough_plastic anti_glare_glass rough_glass \
textured_roughness measured_materials wood"

title() { sed -n '1s/^<!-- *\(.*\)\.$/\1/p' "scenes/gallery/$1.xml"; }
about() {
    sed -n '2,/-->/p' "scenes/gallery/$1.xml" | tr '\n' ' ' | sed 's/^ *//; s/ *-->.*$//; s/  */ /g'
}

for figure in $figures; do
    echo "$(title "$figure")"
    if [ -n "$docs" ]; then
        "$BRDFCL" render "scenes/gallery/$figure.xml" -o "$out/$figure.png" -D width=640 \
            -D height="$(sed -n 's/.*"height" value="\([0-9]*\)".*/\1/p' \
                "scenes/gallery/$figure.xml" | awk '{ print int($1 * 2 / 3); exit }')" --quiet
    else
        "$BRDFCL" render "scenes/gallery/$figure.xml" -o "$out/$figure.png" --quiet
    fi
done

if [ -n "$docs" ]; then
    {
        echo '# Gallery'
        echo
        echo 'The figures of a lecture on modelling BRDFs, one scene each in `scenes/gallery`. `make gallery`'
        echo 'renders them; this page is written by `tools/make_gallery.sh --docs docs/gallery`.'
        for figure in $figures; do
            printf '\n## %s\n\n%s\n\n![%s](gallery/%s.png)\n\n`scenes/gallery/%s.xml`\n' \
                "$(title "$figure")" "$(about "$figure")" "$(title "$figure")" "$figure" "$figure"
        done
    } >docs/gallery.md
else
    {
        echo '<!DOCTYPE html><meta charset="utf-8"><title>brdfcl: gallery</title>'
        echo '<style>body{font:16px/1.5 sans-serif;max-width:62em;margin:2em auto;background:#222;color:#ddd}img{max-width:100%}</style>'
        for figure in $figures; do
            printf '<h2>%s</h2><p>%s</p><img src="%s.png" alt="%s">\n' \
                "$(title "$figure")" "$(about "$figure")" "$figure" "$(title "$figure")"
        done
    } >"$out/index.html"
    echo "The gallery is $out/index.html"
fi
