// Files that travel inside the program.
#pragma once

// Defines `symbol`, the bytes of the file at `path` (a string literal), a zero byte behind them, and `symbol##_end`, which points to that byte.
#define EMBED(symbol, path)                                                                                                  \
  __asm__(".pushsection .rodata\n.balign 16\n" #symbol ":\n.incbin \"" path "\"\n" #symbol "_end:\n.byte 0\n.popsection\n"); \
  extern "C" const unsigned char symbol[] __attribute__((visibility("hidden")));                                             \
  extern "C" const unsigned char symbol##_end[] __attribute__((visibility("hidden")))
