// What a topic's subjects may be asked, and how messages call it: one table a topic.
#pragma once

#include <cstddef>

/// TABLE(ROW) has a ROW(name, "as messages call it") an entry.  Defines in the topic's namespace
///   enum class Entry { name... };
///   name_of(e) = the words of e's row.
#define MMVERIFY_ENTRIES(TABLE)                                    \
  enum class Entry { TABLE(MMVERIFY_ENTRY_NAME) };                 \
  constexpr const char* name_of(Entry e) {                         \
    constexpr const char* words[] = {TABLE(MMVERIFY_ENTRY_WORDS)}; \
    return words[static_cast<std::size_t>(e)];                     \
  }
#define MMVERIFY_ENTRY_NAME(name, words) name,
#define MMVERIFY_ENTRY_WORDS(name, words) words,
