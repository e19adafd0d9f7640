/*
 * scene_text.c - materials as they are written in a scene file.
 */
#include <brdf/info.h>
#include <brdf/model.h>

#include "scene_text.h"

static void indent_by(FILE *file, int levels)
{
    fprintf(file, "%*s", 4 * levels, "");
}

static void write_parameter(FILE *file, const struct brdf_material *material,
                            const struct brdf_model_info *model,
                            const struct brdf_parameter_info *parameter, int indent)
{
    char option[64];
    int place = brdf_parameter_place(model, parameter);
    const float *word = material->word + place;
    if (place < 0) {
        return;
    }
    indent_by(file, indent);
    if (parameter->kind == BRDF_KIND_CHOICE) {
        brdf_parameter_item(parameter, (int)(material->choices >> (4 * place) & 15u), option,
                            sizeof option);
        fprintf(file, "<string name=\"%s\" value=\"%s\"/>\n", parameter->name, option);
    } else if (parameter->kind == BRDF_KIND_REAL) {
        fprintf(file, "<float name=\"%s\" value=\"%.9g\"/>\n", parameter->name, (double)word[0]);
    } else {
        fprintf(file, "<rgb name=\"%s\" value=\"%.9g %.9g %.9g\"/>\n", parameter->name,
                (double)word[0], (double)word[1], (double)word[2]);
    }
}

static void write_part(FILE *file, const struct brdf_bsdf *bsdf, int indent)
{
    const struct brdf_material *material = brdf_bsdf_material(bsdf);
    const struct brdf_model_info *model = brdf_model_info((int)material->model);
    indent_by(file, indent);
    fprintf(file, "<bsdf type=\"%s\">\n", model->name);
    for (size_t i = 0; i < model->parameter_count; ++i) {
        write_parameter(file, material, model, &model->parameters[i], indent + 1);
    }
    indent_by(file, indent);
    fputs("</bsdf>\n", file);
}

void lab_scene_text(FILE *file, const struct brdf_bsdf *const *parts, const double *weights,
                    int count, int indent)
{
    /* A blend is (1 - weight) of its first material and weight of its second, which holds what is
       left: the first part is taken off, and so on. */
    double left = 1.0;
    for (int i = 0; i + 1 < count; ++i) {
        double rest = left - weights[i];
        double weight = left > 0.0 && rest > 0.0 ? rest / left : 0.0;
        indent_by(file, indent + i);
        fputs("<bsdf type=\"blendbsdf\">\n", file);
        indent_by(file, indent + i + 1);
        fprintf(file, "<float name=\"weight\" value=\"%.9g\"/>\n", weight);
        write_part(file, parts[i], indent + i + 1);
        left = rest;
    }
    write_part(file, parts[count - 1], indent + count - 1);
    for (int i = count - 2; i >= 0; --i) {
        indent_by(file, indent + i);
        fputs("</bsdf>\n", file);
    }
}
