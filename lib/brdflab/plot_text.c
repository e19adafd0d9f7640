/* plot_text.c - texts with lowered and raised letters. */
#include <string.h>

#include "plot_canvas.h"

/* A piece of a text: how long it is, and whether it is lowered (-1) or raised (1). */
struct piece {
    const char *begin;
    size_t length;
    int level;
};

static size_t letter_length(const char *text)
{
    size_t length = 1;
    while (((unsigned char)text[length] & 0xC0u) == 0x80u) { /* UTF-8 goes on */
        ++length;
    }
    return length;
}

/* The piece at *at, which moves on; 0 at the end of the text. */
static int next_piece(const char **at, int literal, struct piece *piece)
{
    const char *text = *at;
    if (!*text) {
        return 0;
    }
    if (literal) {
        struct piece all = {text, strlen(text), 0};
        *piece = all;
        *at = text + all.length;
        return 1;
    }
    if (text[0] == '_' && text[1]) {
        struct piece lowered = {text + 1, letter_length(text + 1), -1};
        *piece = lowered;
        *at = lowered.begin + lowered.length;
        return 1;
    }
    const char *end = text[0] == '^' && text[1] == '{' ? strchr(text, '}') : NULL;
    if (end) {
        struct piece raised = {text + 2, (size_t)(end - text) - 2, 1};
        *piece = raised;
        *at = end + 1;
        return 1;
    }
    size_t length = 1;
    while (text[length] && text[length] != '_' &&
           !(text[length] == '^' && text[length + 1] == '{')) {
        ++length;
    }
    struct piece plain = {text, length, 0};
    *piece = plain;
    *at = text + length;
    return 1;
}

static void choose_font(struct plot_canvas *canvas, struct plot_font font, int level)
{
    cairo_select_font_face(canvas->cairo, "sans", CAIRO_FONT_SLANT_NORMAL,
                           font.weight == PLOT_BOLD ? CAIRO_FONT_WEIGHT_BOLD
                                                    : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(canvas->cairo, level ? 0.72 * font.size : font.size);
}

/* Go through the pieces from (x, y), drawing them or not; returns the width. */
static double set_text(struct plot_canvas *canvas, double x, double y, struct plot_font font,
                       const char *text, int draw)
{
    double begin = x;
    struct piece piece;
    while (next_piece(&text, font.literal, &piece)) {
        char bytes[512];
        size_t length = piece.length < sizeof bytes - 1 ? piece.length : sizeof bytes - 1;
        memcpy(bytes, piece.begin, length);
        bytes[length] = '\0';
        choose_font(canvas, font, piece.level);
        cairo_text_extents_t extents;
        cairo_text_extents(canvas->cairo, bytes, &extents);
        if (draw) {
            double lift = piece.level < 0 ? 0.18 : piece.level > 0 ? -0.36 : 0.0;
            plot_set_color(canvas, font.color);
            cairo_move_to(canvas->cairo, x, y + lift * font.size);
            cairo_show_text(canvas->cairo, bytes);
            cairo_new_path(canvas->cairo);
        }
        x += extents.x_advance;
    }
    return x - begin;
}

double plot_text_width(struct plot_canvas *canvas, struct plot_font font, const char *text)
{
    return set_text(canvas, 0.0, 0.0, font, text, 0);
}

void plot_text(struct plot_canvas *canvas, double x, double y, double align, struct plot_font font,
               const char *text)
{
    if (align > 0.0) {
        x -= align * plot_text_width(canvas, font, text);
    }
    set_text(canvas, x, y, font, text, 1);
}

void plot_text_haloed(struct plot_canvas *canvas, double x, double y, double align,
                      struct plot_font font, const char *text)
{
    double width = plot_text_width(canvas, font, text);
    cairo_rectangle(canvas->cairo, x - align * width - 1.5, y - 0.82 * font.size, width + 3.0,
                    1.05 * font.size);
    plot_set_color(canvas, plot_faded(canvas->theme->paper, 0.85));
    cairo_fill(canvas->cairo);
    plot_text(canvas, x, y, align, font, text);
}
