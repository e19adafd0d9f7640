#!/bin/sh
# cli.sh - the command as a person or a script meets it: what it prints, what it leaves, how it exits.
set -eu

. "$(dirname "$0")/support_cli"
made='scene.xml broken.xml'

cat >scene.xml <<'XML'
<scene version="3.0.0">
  <default name="albedo" value="0.5"/>
  <integrator type="path"><integer name="max_depth" value="4"/></integrator>
  <sensor type="perspective">
    <float name="fov" value="40"/>
    <transform name="to_world"><lookat origin="0, 1, 5" target="0, 1, 0" up="0, 1, 0"/></transform>
    <sampler type="independent"><integer name="sample_count" value="4"/></sampler>
    <film type="hdrfilm"><integer name="width" value="48"/><integer name="height" value="32"/></film>
  </sensor>
  <emitter type="constant"><rgb name="radiance" value="1, 1, 1"/></emitter>
  <shape type="sphere"><point name="center" x="0" y="1" z="0"/>
    <bsdf type="diffuse"><rgb name="reflectance" value="$albedo"/></bsdf></shape>
</scene>
XML
echo '<scene version="3.0.0"><sensor type="perspective"/><shape type="spere"/></scene>' >broken.xml

# --- The command itself ----------------------------------------------------------------------------

expect 0 --help
says out 'render'
expect 0 --version
says out '^brdfcl [0-9]'
expect 2
refused 2 'did you mean "render"' rendr scene.xml
for command in render models devices eval sample albedo test check bench; do
    last="$command --help"
    expect 0 "$command" --help
    says out "^usage: brdfcl $command"
    refused 2 'unknown option' "$command" --no-such-option
done

# --- models, devices -------------------------------------------------------------------------------

last=models
expect 0 models
for model in diffuse phong roughconductor dielectric merl; do
    says out "^$model "
done
last='models roughconductor'
expect 0 models roughconductor
says out 'alpha_u .*roughness'
says out 'from 0.0001 to '
says out 'ggx'
says out 'reference: '
last='models roughdiffuse'
expect 0 models roughdiffuse
says out '^orennayar: '
says out 'also called roughdiffuse'
refused 1 'did you mean "phong"' models phnog
refused 2 'too many' models phong diffuse
last=devices
expect 0 devices
says out 'lanes'
last='devices without OpenCL'
status=0
OCL_ICD_VENDORS=/nonexistent "$BRDFCL" devices >out 2>err || status=$?
holds "devices: status $status without OpenCL" [ "$status" -eq 1 ]
says err 'backend c'

# --- eval, sample ----------------------------------------------------------------------------------

last='eval diffuse' # reflectance / pi; cos(60 degrees) = 1/2
expect 0 eval diffuse:reflectance=0.5 --wo 0,0 --wi 60,0
says out '^f  *0\.159154[0-9]* 0\.159154[0-9]* 0\.159154[0-9]*  1/sr'
says out '^f cos  *0\.0795774[0-9]* '
says out '^pdf  *0\.1591549'
copper=roughconductor:material=Cu,alpha_u=0.3,alpha_v=0.1
expect 0 eval $copper --wo 30,10 --wi=40,170 --backend c
cp out c.txt
expect 0 eval $copper --wo=30,10 --wi 40,170 --backend opencl --lanes 4
holds 'eval: C and OpenCL differ' cmp -s out c.txt
rm c.txt
refused 2 'needs both' eval diffuse --wo 0,0
refused 2 'expected THETA,PHI' eval diffuse --wo 0 --wi 0,0
refused 1 'theta goes from 0 to 180' eval diffuse --wo 0,0 --wi 181,0
refused 1 'did you mean' eval difuse --wo 0,0 --wi 0,0
refused 1 'range' eval phong:exponent=-1 --wo 0,0 --wi 0,0

last='sample phong'
expect 0 sample phong --wo 40,0 --count 5 --seed 3
cp out five.txt
says out '^u1,u2,u3,x,y,z,theta,phi,weight_r,weight_g,weight_b,pdf,eta,delta$'
holds 'sample: not five lines and a heading' [ "$(wc -l <out)" -eq 6 ]
holds 'sample: some line has not 14 fields' awk -F, 'NF != 14 { exit 1 }' out
expect 0 sample phong --wo 40,0 --count 5 --seed 3
holds 'sample: the same seed gave other numbers' cmp -s out five.txt
expect 0 sample phong --wo 40,0 --count 5 --seed 4
holds 'sample: another seed gave the same numbers' [ "$(cat out)" != "$(cat five.txt)" ]
rm five.txt
expect 0 sample dielectric --wo 40,0 --count 3
holds 'sample: a delta lobe that is none' awk -F, 'NR > 1 && $14 != 1 { exit 1 }' out
refused 1 'out of range' sample phong --wo 0,0 --count 0
if [ -c /dev/full ]; then
    last='sample >/dev/full' status=0
    "$BRDFCL" sample phong --wo 0,0 >/dev/full 2>err || status=$?
    holds "sample to a full disk: status $status" [ "$status" -eq 1 ]
fi

# --- check, bench ----------------------------------------------------------------------------------

last='check diffuse'
expect 0 check diffuse --count 1000
says out '^diffuse  *sample  *32  *[0-9][0-9]*  *0  *0$'
holds 'check: not a line for each operation and lane count' [ "$(wc -l <out)" -eq 16 ]
last="check $copper"
expect 0 check $copper --count 1000
says out '^roughconductor  *eval  *8  *1000  *0  *0$'
refused 1 'did you mean' check difuse
refused 1 'cannot be opened\|No such file' check merl:filename=nope.binary
last='bench diffuse'
expect 0 bench diffuse --quick --rounds 2 --count 2048 --scene scene.xml --spp 1 --json bench.json
says out '^diffuse  *sample+eval+pdf '
says out '^scene.xml  *render '
says out 'PoCL\|OpenCL'
holds 'bench: not valid JSON' valid_json bench.json
# A model that needs a file, by one of its choices: what the list of every model names.
expect 0 bench merl:fill=false --variance --count 1024
rm bench.json
refused 1 'nope.xml' bench --scene nope.xml --quick --rounds 1
refused 1 'folder' bench diffuse --json /nonexistent/bench.json

# --- render: what is refused -----------------------------------------------------------------------

refused 2 'missing' render
refused 2 'too many' render scene.xml scene.xml
refused 2 'did you mean "--spp"' render scene.xml --sp 4
refused 2 'needs a value' render scene.xml --spp
refused 2 'whole number' render scene.xml --spp many
refused 2 'takes no value' render scene.xml --quiet=yes
refused 2 'one of opencl|c' render scene.xml --backend cuda
refused 2 'WIDTHxHEIGHT' render scene.xml --size 640
refused 2 'backend c' render scene.xml --backend c --lanes 8
refused 1 'from 1 to' render scene.xml --spp 0
refused 1 'from 1 to' render scene.xml --spp 99999999999999999999
refused 1 'from 1 to' render scene.xml --size 0x5
refused 1 'from 1 to' render scene.xml --size 5x1000000
refused 1 'lanes' render scene.xml --lanes 3
refused 1 '"nope"' render scene.xml --device nope
refused 1 'nope' render scene.xml -D nope=1
refused 1 'NAME=VALUE' render scene.xml -D albedo
refused 1 'nope.xml' render nope.xml
refused 1 'broken.xml:1.*sphere' render broken.xml
refused 1 '/nonexistent/' render scene.xml -o /nonexistent/a.exr
refused 1 'suffix' render scene.xml -o a.exr -o a.jpeg
refused 1 '/nonexistent/' render scene.xml --json /nonexistent/a.json
last='render without OpenCL' status=0
OCL_ICD_VENDORS=/nonexistent "$BRDFCL" render scene.xml >out 2>err || status=$?
holds "render without OpenCL: status $status" [ "$status" -eq 1 ]
says err 'backend c'
empty
last='render under a limit on files' status=0
(ulimit -f 1 && exec "$BRDFCL" render scene.xml --backend c --size 200x200 --quiet -o big.exr) \
    >out 2>err || status=$?
holds "render on a full disk: status $status" [ "$status" -eq 1 ]
empty

# --- render: what comes out ------------------------------------------------------------------------

last='render'
expect 0 render scene.xml --quiet --json - # the default: scene.exr, here
holds 'scene.exr is no OpenEXR file' magic scene.exr 762f3101
cp out cl.json
rm scene.exr
expect 0 render scene.xml --backend c --threads 2 -o a.exr -o a.png --json a.json -D albedo=0.5
says err 'samples'
holds 'a.exr is no OpenEXR file' magic a.exr 762f3101
holds 'a.png is no PNG file' magic a.png 89504e47
holds 'not valid JSON' valid_json a.json
holds 'a.exr does not name the program' grep -q -a 'brdfcl [0-9]' a.exr
for key in scene width height spp depth seed backend device lanes seconds_kernel_build seconds_render \
    samples_per_second rays peak_rss_bytes mean image_hash; do
    holds "no $key in the JSON" grep -q "^  \"$key\": " a.json
done
holds 'other keys in the JSON' [ "$(grep -c '^  "' a.json)" -eq 16 ]
hash_of() {
    grep '"image_hash": "0x[0-9a-f]\{16\}"' "$1"
}
holds 'no hash' hash_of a.json >/dev/null
holds 'C and OpenCL rendered different pictures' [ "$(hash_of a.json)" = "$(hash_of cl.json)" ]
expect 0 render scene.xml --backend c --quiet -o a.exr --json a.json --seed 5
holds '--quiet said something' [ ! -s err ]
holds 'another seed, the same picture' [ "$(hash_of a.json)" != "$(hash_of cl.json)" ]
last='render --size'
expect 0 render scene.xml --backend c --quiet -oa.png --json a.json --size 7x5 --spp 3 --depth -1
for line in '"width": 7,' '"height": 5,' '"spp": 3,' '"depth": -1,' '"lanes": 1,'; do
    says a.json "$line"
done
rm -f a.exr a.png a.json cl.json
if script -qec true /dev/null </dev/null >/dev/null 2>&1; then
    TERM=xterm script -qec "$BRDFCL render scene.xml --backend c --spp 4096 -o a.png" /dev/null \
        </dev/null >out 2>&1 || true
    last='render on a terminal'
    says out '\[=*> *\] .* left, .* samples/s'
    rm -f a.png
fi
empty

# --- render: interrupted ---------------------------------------------------------------------------

# How long it takes until there is something to save depends on the machine: try, then wait longer.
interrupt() { # interrupt SIGNAL STATUS
    for seconds in 1 4 16; do
        status=0
        "$BRDFCL" render scene.xml --backend c --spp 16777216 -o a.exr -o a.png --json a.json \
            >out 2>err &
        process=$!
        sleep "$seconds"
        kill -"$1" "$process"
        wait "$process" || status=$?
        [ ! -s a.exr ] || break
    done
    last="render, interrupted by $1"
    holds "$last: status $status" [ "$status" -eq "$2" ]
    says err 'stopped with [0-9][0-9]* of 16777216 samples'
    holds "$last: a.exr is no OpenEXR file" magic a.exr 762f3101
    holds "$last: a.png is no PNG file" magic a.png 89504e47
    holds "$last: not valid JSON" valid_json a.json
    rm -f a.exr a.png a.json
    empty
}
interrupt INT 130
interrupt TERM 143

finish
