#!/bin/sh
# cli_statistics.sh - the commands that measure and test materials: brdfcl eval in bulk, albedo, test, bench --variance.
set -eu

. "$(dirname "$0")/support_cli"

# --- eval --directions ------------------------------------------------------------------------------

made=pairs.csv
cat >pairs.csv <<'CSV'
wo_x,wo_y,wo_z,wi_x,wi_y,wi_z
0,0,1, 0.6,0,0.8

0.6 0 0.8 -0.6 0 0.8
0,0,1,0,0,-1
CSV
last='eval --directions'
expect 0 eval diffuse:reflectance=0.5 --directions pairs.csv
says out '^f_r,f_g,f_b,pdf$'
says out '^0.159154937,0.159154937,0.159154937,0.2546'
says out '^0,0,0,0$'
holds 'not one line a pair' [ "$(wc -l <out)" -eq 4 ]
cp out c.csv
expect 0 eval diffuse:reflectance=0.5 --directions pairs.csv --backend opencl --lanes 8
holds 'C and OpenCL differ' cmp -s out c.csv
rm c.csv
last='eval --directions -'
status=0
"$BRDFCL" eval diffuse --directions - <pairs.csv >out 2>err || status=$?
holds "status $status" [ "$status" -eq 0 ]
holds 'not one line a pair' [ "$(wc -l <out)" -eq 4 ]
refused 2 'but not both' eval diffuse --directions pairs.csv --wo 0,0
refused 1 'nope.csv' eval diffuse --directions nope.csv
echo '0,0,1,0,0' >>pairs.csv
refused 1 'pairs.csv:6: expected six numbers' eval diffuse --directions pairs.csv
echo '0,0,1,0,0,2' >pairs.csv
refused 1 'pairs.csv:1: wi has the length 2' eval diffuse --directions pairs.csv
rm pairs.csv
made=

# --- albedo ----------------------------------------------------------------------------------------

last='albedo diffuse'
expect 0 albedo diffuse:reflectance=0.2/0.4/0.6 --angles 3
says out '^  theta .*R red'
says out '^   0.00   0.20000  0.40000  0.60000   0.00000'
says out '^  89.00   0.20000  0.40000  0.60000   0.00000'
says out '^average   0.20000  0.40000  0.60000   0.00000'
holds 'not one line an angle' [ "$(wc -l <out)" -eq 5 ]
last='albedo dielectric --csv'
expect 0 albedo dielectric:int_ior=1.5,ext_ior=1 --theta 0,45.5,89.99 --csv --samples 16384
says out '^theta,reflection_r,.*,transmission_b,error$'
says out '^0,0.0[34]'
says out '^45.5,0.0'
says out '^89.99,0.99'
holds 'not one line an angle' [ "$(wc -l <out)" -eq 5 ]
last='albedo dielectric --inside'
expect 0 albedo dielectric:int_ior=1.5,ext_ior=1 --theta 45 --inside
says out '^  45.00   1.00000  1.00000  1.00000   0.00000'
last='albedo --json -'
expect 0 albedo dielectric --angles 2 --json -
cp out albedo.json
holds 'not valid JSON' valid_json albedo.json
for key in material side phi samples albedo theta reflection transmission error albedo_average; do
    says albedo.json "\"$key\": "
done
rm albedo.json
refused 2 'expected numbers' albedo diffuse --theta 10,,20
refused 1 'from 0 to 89.99' albedo diffuse --theta 10,90
refused 1 'from 1 to 256' albedo diffuse --angles 0
refused 1 'black' albedo diffuse --inside
refused 1 "did you mean" albedo difuse
refused 1 '/nonexistent/' albedo diffuse --json /nonexistent/a.json

# --- test ------------------------------------------------------------------------------------------

few='--samples 20000 --calls 2000'
last='test roughconductor'
expect 0 test roughconductor:alpha=0.3 $few
says out '^finite and not negative .* <= 0 .* pass'
says out '^reciprocal .* pass'
says out '^isotropic .* -  .*does not claim'
says out '^chi-square  *60 .* >= 0.002008 .* pass .*degrees of freedom'
says out ' passed, 0 failed, 0 open, 0 noted$'
last='test dielectric'
expect 0 test dielectric $few
says out '^chi-square  *135 .* no samples but deltas'
last='test ward'
expect 1 test ward:variant=ward,alpha=0.3,specular_reflectance=1 $few
says out '^energy  *0  *1.29.* FAIL'
says out '^chi-square .* pass'
last='test --json -'
expect 0 test lommelseeliger $few --json - --seed 7
cp out test.json
holds 'not valid JSON' valid_json test.json
for line in '"seed": 7' '"material": "lommelseeliger"' '"verdict": "pass"' '"failed": 0'; do
    says test.json "$line"
done
rm test.json
last='test --all'
expect 0 test --all lommelseeliger $few
says out '^lommelseeliger  *[0-9][0-9]* .* 0$'
says out ' 0 failed'
refused 2 'one material' test
refused 2 'one material' test diffuse phong
refused 1 'did you mean "phong"' test --all phnog
refused 1 'no model is called' test nothing
refused 1 'from 10000' test diffuse --samples 1

# --- bench --variance ------------------------------------------------------------------------------

last='bench --variance'
expect 0 bench diffuse conductor roughconductor:alpha=0.1,material=Au --variance --count 262144 --json bench.json
says out '^diffuse  *constant  *0.5  *0  *0  *-$'
says out '^conductor  *constant  *0.686.* - '
# A lambertian under a disk: 1 / P - 1, where P = 0.0037980 is the chance of the cosine to hit it.
holds 'a disk under the cosine' awk '/^ +disk / && n++ == 0 { exit !($2 > 0.001898 && $2 < 0.0019 && $4 > 240 && $4 < 285) }' out
holds 'four times below the cosine' awk '/^roughconductor/ { at = 1 } at && /disk/ { n += $NF > 4 } END { exit n != 2 }' out
says bench.json '"relative_variance_cosine": null'
holds 'not valid JSON' valid_json bench.json
rm bench.json

finish
