/* Goes through the elements of an XML text. */
#include "exchange/svg/xml.h"
#include "exchange/reading/scan.h"

#include <limits.h>
#include <stdint.h>
#include <string.h>

void bat_xml_begin(bat_xml *xml, bat_input *input)
{
    *xml = (bat_xml){.input = input, .line = 1, .kind = BAT_XML_NONE, .decoded = {.size = 1}};
}

void bat_xml_end(bat_xml *xml)
{
    bat_release(xml->decoded.items);
}

/* Forward to `to`, counting lines. */
static void advance(bat_xml *xml, size_t to)
{
    for (; xml->at < to; xml->at++)
        xml->line += xml->input->data[xml->at] == '\n' && xml->line < INT_MAX;
}

/* Where a text begins from `from` on; the end when it does not. */
static size_t find(const bat_xml *xml, size_t from, const char *text)
{
    const size_t length = strlen(text), size = xml->input->size;
    const char *data = xml->input->data;
    for (size_t i = from; i + length <= size; i++) {
        const char *first = memchr(data + i, text[0], size - i);
        if (!first)
            return size;
        i = (size_t)(first - data);
        if (i + length <= size && memcmp(first, text, length) == 0)
            return i;
    }
    return size;
}

static bool begins(const bat_xml *xml, const char *text)
{
    const size_t length = strlen(text);
    return xml->input->size - xml->at >= length &&
           memcmp(xml->input->data + xml->at, text, length) == 0;
}

/* Past a comment, a declaration or the like, which begins here; false for an element. A DOCTYPE
 * may hold declarations in brackets. */
static bool skip_other(bat_xml *xml)
{
    const char *end = begins(xml, "<!--")        ? "-->"
                      : begins(xml, "<![CDATA[") ? "]]>"
                      : begins(xml, "<?")        ? "?>"
                                                 : NULL;
    if (!end && !begins(xml, "<!"))
        return false;
    if (!end) {
        const size_t close = find(xml, xml->at, ">");
        end = memchr(xml->input->data + xml->at, '[', close - xml->at) ? "]>" : ">";
    }
    const size_t at = find(xml, xml->at, end), size = xml->input->size;
    advance(xml, at == size ? size : at + strlen(end));
    return true;
}

/* The end of an element that begins at xml->at: '>' outside of quotes. */
static size_t end_of(const bat_xml *xml)
{
    char quote = '\0';
    size_t i = xml->at + 1;
    for (; i < xml->input->size; i++) {
        const char c = xml->input->data[i];
        if (quote ? c == quote : c == '"' || c == '\'')
            quote = quote ? '\0' : c;
        else if (!quote && c == '>')
            break;
    }
    return i;
}

/* The code of a reference by number, "&#49;" or "&#x31;", that begins at `text`; 0 when none
 * does. *length is that of the reference. */
static uint32_t code_of_reference(const char *text, size_t left, size_t *length)
{
    const bool is_hex = left > 2 && (text[2] == 'x' || text[2] == 'X');
    const uint32_t base = is_hex ? 16 : 10;
    uint32_t code = 0;
    size_t i = is_hex ? 3 : 2;
    if (left < 4 || text[0] != '&' || text[1] != '#')
        return 0;
    for (; i < left && text[i] != ';'; i++) {
        const int digit = bat_hex_digit(text[i]);
        if (digit < 0 || (uint32_t)digit >= base || code > 0x10ffff)
            return 0;
        code = base * code + (uint32_t)digit;
    }
    *length = i + 1;
    return i < left ? code : 0;
}

/* Numbers and words of paths are looked for in what the references mean. Quotes and "&" stay
 * references: they would end a value, or begin another. */
static batten_status decode_attributes(bat_xml *xml)
{
    const bat_span a = xml->attributes;
    xml->decoded.count = 0;
    batten_status status = bat_list_reserve(xml->input, &xml->decoded, a.length);
    for (size_t i = 0; status == BATTEN_OK && i < a.length;) {
        size_t length = 1;
        const uint32_t code = code_of_reference(a.bytes + i, a.length - i, &length);
        const char c = (char)(code & 127);
        if (code == 0 || code > 126 || c == '"' || c == '\'' || c == '&') {
            status = bat_list_add(xml->input, &xml->decoded, a.bytes + i);
            i++;
        } else {
            status = bat_list_add(xml->input, &xml->decoded, &c);
            i += length;
        }
    }
    if (status == BATTEN_OK)
        xml->attributes = (bat_span){xml->decoded.items, xml->decoded.count};
    return status;
}

static bool has_number_reference(bat_span text)
{
    for (size_t i = 0; i + 3 < text.length; i++) {
        const char *at = memchr(text.bytes + i, '&', text.length - i);
        if (!at)
            return false;
        i = (size_t)(at - text.bytes);
        if (i + 1 < text.length && at[1] == '#')
            return true;
    }
    return false;
}

/* Without the name space before a colon. */
static void split_element(bat_xml *xml, size_t at, size_t last)
{
    const char *data = xml->input->data;
    size_t begin = at;
    while (at < last && !bat_is_white(data[at])) {
        if (data[at] == ':')
            begin = at + 1;
        at++;
    }
    xml->name = (bat_span){data + begin, at - begin};
    xml->attributes = (bat_span){data + at, last - at};
}

static batten_status read_element(bat_xml *xml)
{
    const char *data = xml->input->data;
    const size_t end = end_of(xml);
    if (end == xml->input->size)
        return bat_input_fail(xml->input, BATTEN_BAD_FORMAT, xml->line,
                              "an element has no end");
    size_t at = xml->at + 1, last = end;
    xml->kind = data[at] == '/' ? BAT_XML_END : BAT_XML_BEGIN;
    at += xml->kind == BAT_XML_END;
    if (xml->kind == BAT_XML_BEGIN && last > at && data[last - 1] == '/') {
        xml->kind = BAT_XML_ALONE;
        last--;
    }
    split_element(xml, at, last);
    return has_number_reference(xml->attributes) ? decode_attributes(xml) : BATTEN_OK;
}

batten_status bat_xml_next(bat_xml *xml)
{
    /* Past the element that was shown last. */
    if (xml->kind != BAT_XML_NONE)
        advance(xml, end_of(xml) + 1);
    xml->kind = BAT_XML_NONE;
    do
        advance(xml, find(xml, xml->at, "<"));
    while (xml->at < xml->input->size && skip_other(xml));
    return xml->at < xml->input->size ? read_element(xml) : BATTEN_OK;
}

bool bat_xml_is(const bat_xml *xml, const char *name)
{
    return xml->name.length == strlen(name) &&
           memcmp(xml->name.bytes, name, xml->name.length) == 0;
}

/* ---- attributes ---- */

/* The attribute that begins at *i or later. */
static bool next_attribute(bat_span a, size_t *i, bat_span *name, bat_span *value)
{
    while (*i < a.length && bat_is_white(a.bytes[*i]))
        ++*i;
    const size_t begin = *i;
    while (*i < a.length && a.bytes[*i] != '=' && !bat_is_white(a.bytes[*i]))
        ++*i;
    *name = (bat_span){a.bytes + begin, *i - begin};
    while (*i < a.length && (bat_is_white(a.bytes[*i]) || a.bytes[*i] == '='))
        ++*i;
    if (*i >= a.length || (a.bytes[*i] != '"' && a.bytes[*i] != '\''))
        return false;
    const char quote = a.bytes[(*i)++];
    const size_t from = *i;
    while (*i < a.length && a.bytes[*i] != quote)
        ++*i;
    *value = (bat_span){a.bytes + from, *i - from};
    ++*i;
    return true;
}

bool bat_xml_attribute(const bat_xml *xml, const char *name, bat_span *value)
{
    bat_span found, text;
    size_t i = 0;
    while (next_attribute(xml->attributes, &i, &found, &text))
        if (bat_word_is(found, name)) {
            *value = text;
            return true;
        }
    return false;
}

/* What a reference, from '&' on, stands for, as UTF-8; 0 bytes when it is none. *length is that
 * of the reference. */
static size_t reference(const char *text, size_t left, size_t *length, char bytes[4])
{
    static const struct {
        const char *text;
        char c;
    } known[] = {
        {"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}};
    const uint32_t code = code_of_reference(text, left, length);
    if (code >= ' ')
        return bat_utf8_write(code, bytes);
    for (size_t k = 0; k < sizeof known / sizeof known[0]; k++) {
        *length = strlen(known[k].text);
        if (left >= *length && memcmp(text, known[k].text, *length) == 0) {
            bytes[0] = known[k].c;
            return 1;
        }
    }
    return 0;
}

void bat_xml_text(const bat_xml *xml, const char *name, size_t size, char *buffer)
{
    bat_span value = {"", 0};
    size_t used = 0;
    (void)bat_xml_attribute(xml, name, &value);
    for (size_t i = 0; i < value.length && used + 4 < size;) {
        size_t length = 1;
        char bytes[4] = {value.bytes[i]};
        const size_t meant =
            bytes[0] == '&' ? reference(value.bytes + i, value.length - i, &length, bytes) : 0;
        memcpy(buffer + used, bytes, meant ? meant : 1);
        used += meant ? meant : 1;
        i += meant ? length : 1;
    }
    buffer[used] = '\0';
}
