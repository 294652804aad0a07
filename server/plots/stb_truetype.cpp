// The implementation of the library, which is a header.
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>
