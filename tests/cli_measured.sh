#!/bin/sh
# cli_measured.sh - the commands that make, describe and change measured files.
set -eu

. "$(dirname "$0")/support_cli"

# --- convert ---------------------------------------------------------------------------------------

last='convert diffuse'
expect 0 convert diffuse:reflectance=0.2/0.4/0.6 matte.binary
says out '^matte.binary: MERL, from diffuse'
says out '^difference  rms [0-9.]*e-0[89]  mean'
says out '^largest '
holds 'not the size of a MERL file' [ "$(wc -c <matte.binary)" -eq 34992012 ]
last='convert --json -'
expect 0 convert roughconductor:material=Cu,alpha=0.2 metal.binary --json -
cp out difference.json
holds 'not valid JSON' valid_json difference.json
for key in material out format difference rms mean albedo largest largest_grazing wo wi theta; do
    says difference.json "\"$key\": "
done
rm difference.json
last='convert metal again'
expect 0 convert metal.binary again.txt --format merl
holds 'a table that is whole changes by being read' cmp -s metal.binary again.txt
rm again.txt

# A hole: 8 bytes each of R, G, B become -1 at theta_h 40, theta_d 20, phi_d 90.
cp matte.binary holed.binary
for plane in 0 1 2; do
    bin=$((plane * 1458000 + (40 * 90 + 20) * 180 + 90))
    printf '\000\000\000\000\000\000\360\277' |
        dd of=holed.binary bs=1 seek=$((12 + 8 * bin)) conv=notrunc 2>/dev/null
done
last='convert a hole'
expect 0 convert holed.binary filled.binary
expect 0 info filled.binary
says out 'above the surface all but 0$'
says out '^least f     0.06'
expect 0 convert holed.binary zero.binary --no-fill
expect 0 info zero.binary
says out 'above the surface all but 0$'
says out '^least f     0 1/sr, at theta_h 18.23, theta_d 20.5, phi_d 90.5 degrees'
rm filled.binary zero.binary

# --- measured files where a material is wanted, under names that a description cannot hold ----------

last='a file as a material'
cp matte.binary "a,b:c 'd'.binary"
expect 0 eval "a,b:c 'd'.binary" --wo 0,0 --wi 60,0
says out '^f  *0\.0636[0-9]* 0\.127[0-9]* 0\.190[0-9]*  1/sr'
expect 0 sample "a,b:c 'd'.binary" --wo 40,0 --count 2
expect 0 albedo "a,b:c 'd'.binary" --samples 1024 --angles 1
says out '^average  *0\.[12]'
expect 0 test "a,b:c 'd'.binary" --calls 1000 --samples 10000
rm "a,b:c 'd'.binary"
mkdir diffuse # a model's name is the model
expect 0 info diffuse
expect 1 info ./diffuse
says err 'a folder'
rmdir diffuse
refused_empty='the name of a material is empty'
for command in info convert; do
    last="$command ''"
    expect 1 $command '' $([ $command = info ] || echo o.binary)
    says err "$refused_empty"
done

# --- info ------------------------------------------------------------------------------------------

last='info'
expect 0 info holed.binary
says out '^format      MERL: isotropic, 90 x 90 x 180'
says out 'above the surface all but 1$'
says out '^  *average   0.2000  0.4000  0.6000'
says out 'never above 1'
says out '^doubt       1 bins above the surface were not measured.*filled from'
expect 0 info holed.binary --no-fill
says out '^doubt       1 bins above the surface were not measured.*count as 0'
last='eval --no-fill'
at='--wo 27.2860503,-49.8086359 --wi 27.0461629,50.3674599' # the centre of the hole
expect 0 eval holed.binary $at
says out '^f  *0\.0636'
expect 0 eval holed.binary $at --no-fill
says out '^f  *\(0\|[0-9.]*e-[0-9]*\|0\.000[0-9]*\) '
cp out unfilled
expect 0 eval merl:filename=holed.binary,fill=false $at
holds '--no-fill is not fill=false' cmp -s out unfilled
expect 1 eval merl:filename=holed.binary,fill=no $at
says err "fill.*false"
cat >scene.xml <<'END'
<scene version="3.0.0"><sensor type="perspective"/><shape type="sphere"><bsdf type="merl">
<string name="filename" value="holed.binary"/><boolean name="fill" value="false"/></bsdf></shape>
<emitter type="constant"/></scene>
END
expect 0 render scene.xml --size 4x4 --spp 1 --backend c --quiet -o a.png
rm unfilled scene.xml a.png
last='info, a whole turn'
{ # 90 x 90 x 360 bins of f = 1/1500 in R, and what the units make of it in the others
    printf '\132\0\0\0\132\0\0\0\150\1\0\0'
    yes "$(printf '\001\001\001\001\001\001\360?')" | tr -d '\n' | head -c 69984000
} >turned.binary
expect 0 info turned.binary
says out '^format      MERL: isotropic, 90 x 90 x 360'
says out '^folded      to 180 bins of phi_d: opposite ones, which differ by 0 of f'
rm turned.binary
last='info --json -'
expect 0 info metal.binary --json -
cp out info.json
holds 'not valid JSON' valid_json info.json
for key in material format bins valid_fraction least largest noise albedo reciprocity energy doubts; do
    says info.json "\"$key\": "
done
rm info.json holed.binary

# --- RGL -------------------------------------------------------------------------------------------

last='convert to RGL and back'
expect 0 convert roughconductor:material=Cu,alpha=0.2 metal.bsdf --thetas 9 --size 32
says out '^metal.bsdf: RGL, from roughconductor'
says out '^difference  rms 0.00*[1-9]'
expect 0 info metal.bsdf
says out '^format      RGL: isotropic, RGB'
says out '1 x 9 views .* each 32 x 32, 3 channels'
says out '^valid       100.0 % of the values'
says out '^largest f   [0-9.]* 1/sr, at wo [0-9.]*, wi [0-9.]* degrees from the normal'
expect 0 info metal.bsdf --json -
cp out info.json
holds 'not valid JSON' valid_json info.json
for key in format valid_fraction theta_o theta_i azimuths polar_angles size channels spectral least largest albedo; do
    says info.json "\"$key\": "
done
expect 0 convert metal.bsdf back.binary
says out '^back.binary: MERL, from metal.bsdf'
expect 0 convert roughconductor:alpha_u=0.1,alpha_v=0.3 brushed.bsdf --thetas 5 --size 16
expect 0 info brushed.bsdf
says out '^format      RGL: anisotropic, RGB'
says out '9 x 5 views'
expect 1 convert brushed.bsdf o.binary
says err 'turned about its normal'
rm info.json metal.bsdf brushed.bsdf back.binary

# --- mix -------------------------------------------------------------------------------------------

same() { # same A B WHAT
    holds "$3" cmp -s "$1" "$2"
    rm "$2"
}
last='mix'
for space in linear log-relative; do
    expect 0 mix metal.binary metal.binary mixed.binary --weight 0.3 --space $space
    same metal.binary mixed.binary 'mixing with itself changes bits'
    expect 0 mix matte.binary metal.binary mixed.binary --weight 0 --space $space
    same matte.binary mixed.binary 'weight 0 is not the first'
    expect 0 mix matte.binary metal.binary mixed.binary --weight 1 --space $space
    same metal.binary mixed.binary 'weight 1 is not the second'
done
expect 0 mix matte.binary metal.binary roughplastic mixed.binary --weight 0.2,0.3
says out '^mixed.binary: 0.5 matte.binary + 0.2 metal.binary + 0.3 roughplastic, log-relative'
expect 0 info mixed.binary
rm mixed.binary
made='matte.binary metal.binary'
refused 2 'an argument is missing' mix a b
refused 2 'leave it none' mix diffuse phong ward o.binary --weight 0.6,0.6
refused 2 '3 weights for 2 materials' mix diffuse phong o.binary --weight 1,2,3
refused 2 'all weights are 0' mix diffuse phong o.binary --weight 0,0
last='mix to RGL'
expect 0 mix matte.binary roughplastic:alpha=0.3 mixed.bsdf --weight 0.4 --thetas 9 --size 32
says out '^roughplastic:alpha=0.3: onto MERL.s grid$'
says out '^mixed.bsdf: from MERL.s grid into RGL.s$'
says out '^difference  rms 0.0.*99% below 0.*albedo 0.0'
expect 0 mix mixed.bsdf mixed.bsdf again.bsdf
same mixed.bsdf again.bsdf 'mixing an RGL file with itself changes bits'
expect 0 info mixed.bsdf
says out 'RGL: isotropic'
rm mixed.bsdf
refused 2 '"./metal.binary" is read and written' mix diffuse metal.binary ./metal.binary
refused 2 'no suffix that tells its format' mix diffuse phong o.txt
refused 2 'one of log-relative' mix diffuse phong o.binary --space cubic
refused 1 'did you mean "diffuse"' mix difuse phong o.binary
refused 1 '^brdfcl: ashikhminshirley:.*turned about its normal' mix diffuse ashikhminshirley:exponent_u=10,exponent_v=900 o.binary

# --- edit ------------------------------------------------------------------------------------------

last='edit'
expect 0 edit metal.binary edited.binary
says out '^edited.binary: metal.binary, unchanged'
same metal.binary edited.binary 'an edit of nothing changes bits'
expect 0 edit metal.binary edited.binary --gloss 1 --hue 0 --saturation 1 --specular 1 --diffuse 1
same metal.binary edited.binary 'an edit of nothing changes bits'
expect 0 edit matte.binary edited.binary --diffuse 0.5
expect 0 info edited.binary
says out '^  *average   0.1000  0.2000  0.3000'
expect 0 edit matte.binary edited.binary --saturation 0
says out '^edited.binary: matte.binary, edited'
expect 0 info edited.binary
says out '^  *average   0.3[0-9]*  0.3[0-9]*  0.3'
rm edited.binary
last='edit to RGL'
expect 0 edit matte.binary edited.bsdf --diffuse 0.5 --thetas 9 --size 32
says out '^edited.bsdf: from MERL.s grid into RGL.s$'
expect 0 info edited.bsdf
says out '^  *average   0.\(10\|099\)[0-9]*  0.\(20\|19\)[0-9]*  0.\(30\|29\)[0-9]*$'
expect 0 edit edited.bsdf again.bsdf
says out '^again.bsdf: edited.bsdf, unchanged'
same edited.bsdf again.bsdf 'an edit of nothing changes bits'
rm edited.bsdf
last='a narrow lobe over a matte base as RGL'
expect 0 convert roughplastic:alpha=0.05 o.bsdf
holds 'its albedo is off by more than 0.04' awk '/^difference/ { exit !($NF < 0.04) }' out
rm o.bsdf
last='edit in place'
cp matte.binary place.binary
made="$made place.binary"
refused 2 '"place.binary" is read and written: .*--force' edit place.binary place.binary --diffuse 0.5
refused 2 'is read and written' convert ./place.binary place.binary
same matte.binary place.binary 'a refused edit changes the file'
cp matte.binary place.binary
expect 0 edit place.binary place.binary --diffuse 0.5 --force
expect 0 info place.binary
says out '^  *average   0.1000  0.2000  0.3000'
rm place.binary
made='matte.binary metal.binary'
refused 2 'one of all|diffuse|specular' edit diffuse o.binary --part none
refused 1 'from 0.05 to 20' edit diffuse o.binary --gloss 0

# --- what is refused -------------------------------------------------------------------------------

refused 2 'no suffix' convert diffuse o.exr
refused 1 'mirror direction' convert conductor o.binary
refused 1 'lets light through' convert roughdielectric o.binary
refused 1 'lets light through' convert principled:spec_trans=0.5 o.binary
last='convert an opaque principled'
expect 0 convert principled:roughness=0.5,metallic=1 o.binary
says out '^difference  rms 0.00'
rm o.binary
refused 1 'is a folder' convert diffuse /tmp --format merl
refused 1 '/nonexistent' convert diffuse /nonexistent/o.binary
refused 1 'No such file' info difuse.binary
refused 1 'a folder' info /tmp
head -c 1000 matte.binary >cut
last='info cut'
expect 1 info cut
says err 'cut off'

# A full disk leaves what was there before.
echo before >cut
made="$made cut"
last='convert on a full disk'
status=0
(ulimit -f 1000 && exec "$BRDFCL" convert diffuse cut --format merl) >out 2>err || status=$?
holds 'a full disk is no error' [ "$status" -eq 1 ]
says err '^brdfcl: .*too large'
holds 'the old file is gone' [ "$(cat cut)" = before ]
empty

finish
