/* The elements of an XML text, one after another: as much of XML as drawings need. */
#ifndef BAT_XML_H
#define BAT_XML_H
#include "exchange/reading/input.h"

typedef enum { BAT_XML_BEGIN, BAT_XML_END, BAT_XML_ALONE, BAT_XML_NONE } bat_xml_kind;

typedef struct {
    bat_input *input;
    size_t at;
    int line; /* of the element */
    bat_xml_kind kind;
    bat_span name;       /* without a prefix and its colon */
    bat_span attributes; /* with digits and such instead of their references by number */
    bat_list decoded;    /* the memory of these, where there are any */
} bat_xml;

void bat_xml_begin(bat_xml *xml, bat_input *input);
void bat_xml_end(bat_xml *xml);
/* Go to the next element; the kind is NONE at the end of the text. Comments, declarations and
 * text between elements are skipped. BAD_FORMAT for an element without an end. */
batten_status bat_xml_next(bat_xml *xml);
bool bat_xml_is(const bat_xml *xml, const char *name);
/* The value of an attribute as it stands between its quotes; false when there is none. */
bool bat_xml_attribute(const bat_xml *xml, const char *name, bat_span *value);
/* The same copied, with its character references resolved, cut to the buffer; "" for none. */
void bat_xml_text(const bat_xml *xml, const char *name, size_t size, char *buffer);

#endif
