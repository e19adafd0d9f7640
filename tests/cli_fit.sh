#!/bin/sh
# cli_fit.sh - brdfcl fit: what it finds, and what it refuses.
set -eu

. "$(dirname "$0")/support_cli"

last='fit ward'
expect 0 fit ward:alpha=0.2,specular_reflectance=0.1/0.2/0.3 --model ward --starts 1
says out '^error '
says out '^fit  *ward:variant=balanced,alpha_u=0.\(2\|19999\)'
says out '<bsdf type="ward">'
says out '<rgb name="specular_reflectance" value="0.\(1\|0999\)'

# A blend is printed as a scene holds it.
last='fit --diffuse'
expect 0 fit diffuse:reflectance=0.2/0.4/0.6 --model roughplastic:diffuse_reflectance=0,alpha=0.2 \
    --diffuse --starts 1 --evaluations 200
says out '^part  *[0-9.]* of diffuse:reflectance='
says out '<bsdf type="blendbsdf">'
says out '<float name="weight" value="'

last='fit -o'
made=fit.svg
expect 0 fit phong:exponent=20 --model blinnphong --starts 1 --evaluations 100 -o fit.svg
says fit.svg '<svg'
refused 1 'a .png or a .svg' fit diffuse --model ward -o fit.gif

refused 2 'needs --model' fit diffuse
refused 1 'did you mean .ward.' fit diffuse --model wrad
refused 1 'nothing to search' fit diffuse --model diffuse:reflectance=0.5
refused 1 'take another model' fit diffuse --model conductor
refused 1 'did you mean .alpha_u.' fit diffuse --model ward --free alpa_u
refused 1 '/nonexistent/gold.binary' fit /nonexistent/gold.binary --model ward

finish
