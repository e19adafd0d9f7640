#!/bin/sh
# docs.sh - the pages: what `make docs` is to show is valid, and what pages link to and show is there.
set -eu

folder=$(pwd)
. "$(dirname "$0")/support_cli"
table=$folder/docs/models/pictures.txt

grep -v -e '^ *#' -e '^ *$' -e filename "$table" >table
while IFS='|' read -r model settings; do
    echo "$settings" | tr '|' '\n' >settings
    while read -r setting; do
        [ "$setting" = - ] && setting= || setting=:$setting
        last="eval $(echo $model)$setting"
        expect 0 eval "$(echo $model)$setting" --wo 10,0 --wi 20,0
    done <settings
done <table

# One page made anew, beside the tree: a line of the table with its pictures.
mkdir -p tree/docs tree/scenes
cp -r "$folder/docs/models" tree/docs
cp "$folder/scenes/models.xml" tree/scenes
rm tree/docs/models/images/diffuse*
last='make_docs.sh diffuse'
(cd tree && SPP=1 BRDFCL=$BRDFCL "$folder/tools/make_docs.sh" diffuse >../made 2>&1) || fail 'failed'
holds 'no picture of diffuse' [ -s tree/docs/models/images/diffuse.png ]
holds 'no lobe of diffuse' [ -s tree/docs/models/images/diffuse_lobe.svg ]
holds 'the page changed' cmp -s tree/docs/models/diffuse.md "$folder/docs/models/diffuse.md"

for page in "$folder"/*.md "$folder"/docs/*.md "$folder"/docs/models/*.md; do
    grep -o '](\([^)#:]*\)[^):]*)\|src="[^"]*"' "$page" |
        sed -e 's/^](//' -e 's/[)#].*$//' -e 's/^src="//' -e 's/"$//' >links || true
    while read -r link; do
        holds "$(basename "$page") links to $link, which is not there" \
            [ -z "$link" -o -e "$(dirname "$page")/$link" ]
    done <links
done

finish
