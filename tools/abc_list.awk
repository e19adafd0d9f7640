# abc_list.awk - a table of ABC parameters as a list of materials for `brdfcl navigate --list`.
#
#   awk -f tools/abc_list.awk abc_low2012.csv > abc.txt
#
# Columns: material, kD (r, g, b), A (r, g, b), B, C, ior; a header line comes first.
BEGIN { FS = "," }
NR > 1 && NF >= 10 {
    printf "%s abc:diffuse_reflectance=%s/%s/%s,A=%s/%s/%s,B=%s,C=%s,ior=%s\n", $1, $2, $3, $4, \
        $5, $6, $7, $8, $9, $10
}
