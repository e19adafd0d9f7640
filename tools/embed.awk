# embed.awk - text files as C: a table of names and lines, for a program that needs no files.
#
#   awk -v table=NAME -v header=FILE.h [-v strip=PREFIX] -f embed.awk FILES > OUT.c
#
# One string literal a line of text, because a C99 compiler need not accept more than 4095 characters
# in one. `?` is escaped as well: two of them in a row could begin a trigraph.

BEGIN {
    print "/* Made by tools/embed.awk. */"
    print "#include \"" header "\""
    count = 0
}

FNR == 1 {
    if (count > 0)
        print "    0};"
    name[count] = FILENAME
    if (strip != "" && index(FILENAME, strip) == 1)
        name[count] = substr(FILENAME, length(strip) + 1)
    print "\nstatic const char *const file_" count "[] = {"
    ++count
}

{
    gsub(/[\\"?]/, "\\\\&")
    gsub(/\t/, "\\t")
    gsub(/\r/, "\\r")
    print "    \"" $0 "\","
}

END {
    if (count > 0)
        print "    0};"
    print "\nconst struct brdf_source_file " table "[] = {"
    for (i = 0; i < count; ++i)
        print "    {\"" name[i] "\", file_" i "},"
    print "    {0, 0}};"
}
