/* The errors of a design's text: each is a note with its place, and the first is the message.
 */
#include "design/text/document.h"

#include <stdarg.h>
#include <stdio.h>

void bat_complain_at(bat_complaints *c, int line, int column, const char *sentence)
{
    char entity[32] = "";
    if (line > 0)
        snprintf(entity, sizeof entity, "column %d", column);
    batten_notes_add(c->notes, c->file, line, entity, "%s", sentence);
    if (c->count++ > 0)
        return;
    if (line > 0)
        snprintf(c->first, sizeof c->first, "%s:%d:%d: %s", c->file, line, column, sentence);
    else
        snprintf(c->first, sizeof c->first, "%s: %s", c->file, sentence);
}

void bat_complain(bat_document *document, int node, const char *format, ...)
{
    char sentence[600];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(sentence, sizeof sentence, format, arguments);
    va_end(arguments);
    const bat_node *at = node >= 0 ? &document->tree.nodes[node] : NULL;
    bat_complain_at(document->complaints, at ? at->line : 0, at ? at->column : 0, sentence);
}

void bat_complain_of_ring(bat_document *d, int node, const char *what, int count,
                          const char **names)
{
    char ring[400];
    size_t used = 0;
    for (int i = 0; i <= count && used < sizeof ring; i++) {
        const int more =
            snprintf(ring + used, sizeof ring - used, "%s%s", i ? " -> " : "", names[i]);
        used += (size_t)more;
    }
    bat_complain(d, node, "%s need each other in a ring: %s", what, ring);
}
