#!/bin/sh
# make_docs.sh - the pictures of docs/models, where they stand in its pages, and its index; and the
# picture of docs/plots.md.
#
#   tools/make_docs.sh [MODEL...]      all of docs/models/pictures.txt if none is named
#   tools/make_docs.sh --pages         only pages and index, with the pictures that there are
#
# $BRDFCL is the command (build/brdfcl if not set), $SPP the samples for each pixel (512). Each page has
# its pictures between two marks, and gets the marks after its first paragraph if it has none yet. A
# model that the command does not have, or whose measured files are not in $BRDFCL_DATA
# (../shared/data if not set), is left as it is, with a word. The same call makes the same pixels.
set -eu

BRDFCL=${BRDFCL:-$(pwd)/build/brdfcl}
BRDFCL_DATA=${BRDFCL_DATA:-$(pwd)/../shared/data}
SPP=${SPP:-512}
docs=$(pwd)/docs/models
scene=$(pwd)/scenes/models.xml
begin='<!-- Pictures, by make docs -->'
end='<!-- End of pictures -->'
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$docs/images"

# measured_file NAME: bring a file of measurements into the work folder.
measured_file() {
    [ ! -e "$work/$1" ] || return 0
    for folder in "$BRDFCL_DATA" "$BRDFCL_DATA/merl" "$BRDFCL_DATA/rgl"; do
        if [ -e "$folder/$1" ]; then
            ln -s "$folder/$1" "$work/$1"
            return 0
        elif [ -e "$folder/$1.xz" ]; then
            xz -dc "$folder/$1.xz" >"$work/$1"
            return 0
        fi
    done
    return 1
}

# have MODEL SETTINGS: does the command have the model, and are its files there?
have() {
    "$BRDFCL" models "$1" >/dev/null 2>&1 || {
        echo "$1: the command has no such model" >&2
        return 1
    }
    for file in $(echo "$2" | tr ',|' '\n\n' | sed -n 's/^ *filename[_a-z]*=//p'); do
        measured_file "$file" || {
            echo "$1: no $file in $BRDFCL_DATA" >&2
            return 1
        }
    done
}

# settings LINE NUMBER: "a=1,b=2", or nothing where the table has a dash.
settings() {
    echo "$1" | cut -d'|' -f"$2" | sed 's/^ *//; s/ *$//; s/^-$//'
}

# xml MODEL SETTINGS ID: a material of a scene.
xml() {
    echo "$2" | awk -v model="$1" -v id="$3" '
        BEGIN { RS = "[,\n]"; FS = "="; printf "<bsdf type=\"%s\" id=\"%s\">\n", model, id }
        NF == 2 {
            kind = $2 ~ /\/|^#/ ? "rgb" : $2 ~ /^[-+0-9.e]+$/ ? "float" : "string"
            value = $2
            gsub(/\//, ", ", value)
            printf "  <%s name=\"%s\" value=\"%s\"/>\n", kind, $1, value
        }
        END { print "</bsdf>" }'
}

# pictures MODEL LINE: render the spheres, draw the lobes and the albedo.
pictures() {
    model=$1
    line=$2
    cp "$scene" "$work/scene.xml"
    set --
    number=2
    for id in left middle right; do
        chosen=$(settings "$line" $number)
        set -- "$@" "$model${chosen:+:}$chosen"
        xml "$model" "$chosen" $id >"$work/$id"
        sed -i -e "/<bsdf type=\"diffuse\" id=\"$id\"\/>/{r $work/$id" -e 'd}' "$work/scene.xml"
        number=$((number + 1))
    done
    (
        cd "$work"
        "$BRDFCL" render scene.xml --quiet --spp "$SPP" -o "$docs/images/$model.png"
        "$BRDFCL" plot "$@" --panels lobe,albedo --angles 0,30,60 -o lobe.svg
    )
    # A hundredth of a point is fine enough, and what goes without saying is left out: half the size.
    sed -e 's/\([0-9]\.[0-9][0-9]\)[0-9][0-9]*/\1/g' -e 's/fill-rule:nonzero;//g' \
        -e 's/\(fill\|stroke\)-opacity:1;//g' -e 's/stroke-linecap:butt;//g' \
        -e 's/\([0-9]\)\.[0-9]*%/\1%/g' \
        "$work/lobe.svg" >"$docs/images/${model}_lobe.svg"
}

# page MODEL LINE: put the pictures into its page.
page() {
    [ -e "$docs/$1.md" ] || {
        echo "$1: has no page" >&2
        return 0
    }
    {
        printf '%s\n\n![%s on three spheres](images/%s.png)\n\n' "$begin" "$1" "$1"
        echo "$2" | cut -d'|' -f2- |
            sed -e 's/^ */From left to right: `/' -e 's/ *| */`, `/g' -e 's/$/`./' -e 's/`-`/as initially/g'
        printf '\n![Lobes and albedo of %s](images/%s_lobe.svg)\n\n%s\n' "$1" "$1" "$end"
    } >"$work/block"
    awk -v begin="$begin" -v end="$end" -v block="$work/block" '
        function put(   line) {
            while ((getline line < block) > 0) print line
            close(block)
            done = 1
        }
        { lines[NR] = $0; marked = marked || $0 == begin }
        END {
            for (i = 1; i <= NR; ++i) {
                if (lines[i] == begin) { put(); inside = 1 }
                if (!inside) print lines[i]
                if (lines[i] == end) inside = 0
                text = text || (i > 1 && lines[i] != "" && lines[i] !~ /^#/)
                if (!marked && !done && text && lines[i + 1] == "") { print ""; put() }
            }
        }' "$docs/$1.md" >"$work/page"
    cmp -s "$work/page" "$docs/$1.md" || cp "$work/page" "$docs/$1.md"
}

# index: a table of all models that have a page.
index() {
    printf '# Models\n\nEach model is one header in [include/brdf/model](../../include/brdf/model), '
    printf 'read by C and by OpenCL alike.\n`brdfcl models NAME` prints its parameters; the pictures '
    printf 'are made by `make docs`.\n\n| | model | |\n|---|---|---|\n'
    grep -v '^ *\(#\|$\)' "$docs/pictures.txt" | while IFS='|' read -r model rest; do
        model=$(echo $model)
        [ -e "$docs/$model.md" ] || continue
        summary=$("$BRDFCL" models "$model" | sed -n "1s/^$model: //p")
        image=
        [ ! -e "$docs/images/$model.png" ] ||
            image="<a href=\"$model.md\"><img src=\"images/$model.png\" width=\"320\" alt=\"$model\"></a>"
        echo "| $image | [$model]($model.md) | $summary |"
    done
}

pages_only=
if [ "${1:-}" = --pages ]; then
    pages_only=yes
    shift
fi
grep -v '^ *\(#\|$\)' "$docs/pictures.txt" >"$work/table"
while IFS= read -r line; do
    model=$(settings "$line" 1)
    if [ $# -gt 0 ]; then
        case " $* " in *" $model "*) ;; *) continue ;; esac
    fi
    if [ -z "$pages_only" ]; then
        have "$model" "$line" || continue
        echo "$model"
        pictures "$model" "$line" </dev/null
    fi
    [ ! -e "$docs/images/$model.png" ] || page "$model" "$line"
done <"$work/table"
[ $# -gt 0 ] || [ -n "$pages_only" ] || "$BRDFCL" plot --title 'What brdfcl plot shows' \
    roughconductor:material=Au,distribution=ggx,alpha_u=0.1,alpha_v=0.3 \
    --size 1314x1000 --scale 1.5 -o "$docs/../plots.png"
index >"$work/README.md"
cmp -s "$work/README.md" "$docs/README.md" || cp "$work/README.md" "$docs/README.md"
