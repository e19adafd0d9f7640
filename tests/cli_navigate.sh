#!/bin/sh
# cli_navigate.sh - brdfcl navigate: the map, new materials on it, and what it refuses.
set -eu

. "$(dirname "$0")/support_cli"

cat >set.txt <<'END'
# three materials
dull    phong:exponent=5,specular_reflectance=0.1
shiny   phong:exponent=80,specular_reflectance=0.5,diffuse_reflectance=0.1
diffuse:reflectance=0.2/0.3/0.6
END
made=set.txt

last='navigate --list'
expect 0 navigate --list set.txt --components 2
says out '^variance \[%\]  *[0-9.]*  *[0-9.]*$'
says out '^dull  *-\?[0-9.]*  *-\?[0-9.]*$'
says out '^diffuse:reflectance=0.2'
says out '^gloss  *100.0  how far'

last='navigate -o'
made='set.txt new.binary'
expect 0 navigate --list set.txt --from phong:exponent=20 --trait gloss=0.5 -o new.binary
says out '^new.binary: at '
expect 0 info new.binary
says out 'MERL'
cp new.binary set.binary
rm new.binary
made='set.txt set.binary new.bsdf'
expect 0 navigate --list set.txt --at 0.5 -o new.bsdf --thetas 5 --size 16
says out '^difference  rms 0\.'
expect 0 info new.bsdf
says out 'RGL: isotropic'
rm new.bsdf
made='set.txt set.binary'

refused 2 'give its file, -o' navigate --list set.txt --trait gloss=1
refused 2 'is read and written' navigate --list set.txt --from phong:exponent=20 ./set.binary --at 1 -o set.binary
rm set.binary
made=set.txt
refused 2 'no suffix that tells its format' navigate --list set.txt --at 1 -o new.txt
refused 1 'needs 3 to 10000' navigate diffuse phong
refused 1 'did you mean .gloss.' navigate --list set.txt --trait glos=1 -o new.binary
refused 1 'such as gloss=1.5' navigate --list set.txt --trait gloss -o new.binary
refused 1 'has 4 coordinates' navigate --list set.txt --at 1,2,3,4 -o new.binary
refused 1 'nonexistent.txt' navigate --list nonexistent.txt
printf '# two\nplain diffuse\ngone nonexistent.binary\n' >broken.txt
made="set.txt broken.txt"
refused 1 'broken.txt:3: nonexistent.binary: cannot be opened' navigate --list broken.txt
rm broken.txt
mkdir folder
made='set.txt folder'
refused 1 'holds no .binary' navigate folder

finish
