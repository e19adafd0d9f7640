/* navigate_print.c - a map of materials, and a place of it, as text. */
#include "navigate_print.h"

#include <math.h>
#include <stdio.h>

#include "say.h"

void navigate_print_map(const struct lab_basis *basis, const struct navigate_list *list)
{
    size_t components = (size_t)basis->components;
    printf("%-24s", "component");
    for (size_t k = 0; k < components; ++k) {
        printf(" %7zu", k + 1);
    }
    printf("\n%-24s", "variance [%]");
    for (size_t k = 0; k < components; ++k) {
        printf(" %7.2f", 100.0 * basis->explained[k]);
    }
    printf("\n\n%-24s\n", "coordinates");
    for (size_t i = 0; i < basis->count; ++i) {
        printf("%-24.24s", list->name[i]);
        for (size_t k = 0; k < components; ++k) {
            printf(" %7.3f", basis->coordinate[i * components + k]);
        }
        printf("\n");
    }
    if (basis->count <= components + 2) {
        printf("\n%zu components fit %zu materials whatever they are: \"explained\" means nothing "
               "here, more\nmaterials or a smaller --components would\n",
               components, basis->count);
    }
    printf("\n%-24s  explained [%%] by the components\n", "traits");
    for (int t = 0; t < LAB_TRAITS; ++t) {
        printf("%-24s %7.1f  %s\n", lab_trait_name(t), 100.0 * basis->trait_explained[t],
               lab_trait_meaning(t));
    }
}

void navigate_print_place(const char *path, const struct lab_basis *basis, const double *start,
                          const double *step)
{
    printf("%s: at", path);
    for (int k = 0; k < basis->components; ++k) {
        printf(" %.3f", start[k] + step[k]);
    }
    printf("\n");
    for (int k = 0; k < basis->components; ++k) {
        double z = start[k] + step[k];
        if (fabs(z) > 3.0) {
            say("coordinate %d is %.1f: beyond 3 the map is a guess, nothing was measured there",
                k + 1, z);
        }
    }
}
