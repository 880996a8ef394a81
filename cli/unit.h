/* Units as reports print them. */
#ifndef CLI_UNIT_H
#define CLI_UNIT_H

enum { UNIT_SIZE = 32 };

/* "mm"; "0.75 m" for one without a name; "" when none is stated. */
void unit_words(double metres, char out[UNIT_SIZE]);

#endif
