#!/bin/sh
# cli_statistics.sh - the commands that measure a material: brdfcl albedo.
set -eu

. "$(dirname "$0")/support_cli"

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
for key in bsdf side phi samples angles theta reflection transmission error average; do
    says albedo.json "\"$key\": "
done
rm albedo.json
refused 2 'expected numbers' albedo diffuse --theta 10,,20
refused 1 'from 0 to 89.99' albedo diffuse --theta 10,90
refused 1 'from 1 to 256' albedo diffuse --angles 0
refused 1 'black' albedo diffuse --inside
refused 1 "did you mean" albedo difuse
refused 1 '/nonexistent/' albedo diffuse --json /nonexistent/a.json

finish
