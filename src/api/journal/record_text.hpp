#pragma once
/// Records of a journal as text: a word and values, separated by spaces. Numbers are the shortest that read back as the
/// same; text has bytes that would divide it as %XX. A value is written and read by one description of it:
/// record_values(archive, value) hands its fields to the archive, one after the other.

#include <charconv>
#include <concepts>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace spectralpack {

/// A T that is read, or one that is only written.
template <class Value, class T>
concept ConstOrNot = std::same_as<std::remove_const_t<Value>, T>;

class RecordWriter {
  public:
    explicit RecordWriter(std::string_view word) : text_(word) {}

    template <class... Fields>
    void operator()(const Fields&... fields) {
        (put(fields), ...);
    }
    const std::string& text() const { return text_; }

  private:
    template <class T>
    void put(const T& value) {
        if constexpr (std::is_same_v<T, bool>) {
            text_ += value ? " 1" : " 0";
        } else if constexpr (std::is_enum_v<T>) {
            put(static_cast<int>(value));
        } else if constexpr (std::is_arithmetic_v<T>) {
            char digits[32];
            const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
            text_ += ' ';
            text_.append(digits, end);
        } else {
            record_values(*this, value);
        }
    }
    void put(const std::string& text) {
        constexpr char kDigits[] = "0123456789ABCDEF";
        text_ += " '";
        for (const char c : text) {
            const auto byte = static_cast<unsigned char>(c);
            if (byte <= ' ' || c == '%' || byte == 0x7f) {
                text_ += {'%', kDigits[byte / 16], kDigits[byte % 16]};
            } else {
                text_ += c;
            }
        }
    }
    template <class T>
    void put(const std::vector<T>& list) {
        put(list.size());
        for (const T& element : list) {
            put(element);
        }
    }
    template <class T>
    void put(const std::optional<T>& value) {
        put(value.has_value());
        if (value) put(*value);
    }
    template <class Key, class T>
    void put(const std::map<Key, T>& map) {
        put(map.size());
        for (const auto& [key, value] : map) {
            put(key);
            put(value);
        }
    }

    std::string text_;
};

class RecordReader {
  public:
    /// `text` outlives it.
    explicit RecordReader(std::string_view text) : rest_(text), word_(next()) {}

    std::string_view word() const { return word_; }
    /// All that was asked for was there, and nothing else is.
    bool ok() const { return ok_ && rest_.empty(); }

    template <class... Fields>
    void operator()(Fields&... fields) {
        (take(fields), ...);
    }

  private:
    std::string_view next() {
        const std::size_t end = rest_.find(' ');
        const std::string_view token = rest_.substr(0, end);
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
        return token;
    }

    template <class T>
    void take(T& value) {
        if constexpr (std::is_same_v<T, bool> || std::is_enum_v<T>) {
            int number = 0;
            take(number);
            value = static_cast<T>(number);
        } else if constexpr (std::is_arithmetic_v<T>) {
            const std::string_view token = next();
            const auto [end, failure] = std::from_chars(token.data(), token.data() + token.size(), value);
            ok_ = ok_ && failure == std::errc() && end == token.data() + token.size();
        } else {
            record_values(*this, value);
        }
    }
    void take(std::string& text) {
        const std::string_view token = next();
        ok_ = ok_ && token.starts_with('\'');
        text.clear();
        for (std::size_t i = 1; i < token.size(); ++i) {
            if (token[i] != '%') {
                text += token[i];
                continue;
            }
            unsigned byte = 0;
            const std::string_view digits = token.substr(i + 1, 2);
            const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
            ok_ = ok_ && failure == std::errc() && digits.size() == 2 && end == digits.data() + 2;
            text += static_cast<char>(byte);
            i += 2;
        }
    }
    template <class T>
    void take(std::vector<T>& list) {
        list.clear();
        std::size_t count = 0;
        take(count);
        for (std::size_t i = 0; i < count && ok_; ++i) {
            take(list.emplace_back());
        }
    }
    template <class T>
    void take(std::optional<T>& value) {
        bool there = false;
        take(there);
        value.reset();
        if (there) take(value.emplace());
    }
    template <class Key, class T>
    void take(std::map<Key, T>& map) {
        map.clear();
        std::size_t count = 0;
        take(count);
        for (std::size_t i = 0; i < count && ok_; ++i) {
            Key key{};
            take(key);
            take(map[key]);
        }
    }

    std::string_view rest_, word_;
    bool ok_ = true;
};

}  // namespace spectralpack
