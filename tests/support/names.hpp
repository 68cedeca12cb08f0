#pragma once
/// What a text for people must say, whatever its words: tests of messages ask for facts (names, options, places,
/// numbers), so that a sentence may be written better.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <concepts>
#include <string>
#include <vector>

namespace spectralpack::test {

inline bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
inline bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }

struct Quantity {
    double value = 0;
    std::string unit;  ///< the word behind it, if any
};

/// The numbers that stand by themselves in `text` (2.5 of "2.5 mm at -y", 1 of "cube #1"), in its order, with the word
/// behind each; not those inside of names ("part7", "B.1", "1e4x").
inline std::vector<Quantity> quantities_in(const std::string& text) {
    std::vector<Quantity> found;
    const auto at = [&](std::size_t i) { return i < text.size() ? text[i] : ' '; };
    for (std::size_t i = 0; i < text.size();) {
        const char before = i > 0 ? text[i - 1] : ' ';
        const bool starts = !is_digit(before) && !is_letter(before) && before != '.';
        const std::size_t sign = at(i) == '-' ? 1 : 0;
        Quantity quantity;
        const auto parsed = std::from_chars(text.data() + i, text.data() + text.size(), quantity.value);
        const auto end = static_cast<std::size_t>(parsed.ptr - text.data());
        if (!starts || !is_digit(at(i + sign)) || parsed.ec != std::errc{}) {
            ++i;
            continue;
        }
        i = end;
        if (is_letter(at(end))) continue;
        const std::size_t word = end + (at(end) == ' ' ? 1 : 0);
        for (std::size_t k = word; is_letter(at(k)) || at(k) == '%'; ++k) {
            quantity.unit += at(k);
        }
        found.push_back(quantity);
    }
    return found;
}

/// A word or name (case aside, as the beginning of a word; a number at its end is whole), or a number by its value:
/// exactly where it is whole, else to half a percent, as people are told it.
class Fact {
  public:
    Fact(const char* word) : word_(word) {}
    Fact(std::string word) : word_(std::move(word)) {}
    template <class Number>
    requires std::integral<Number> || std::floating_point<Number> Fact(Number number)
        : number_(static_cast<double>(number)), share_(std::integral<Number> ? 0 : 5e-3) {}

    bool stated_in(const std::string& text) const {
        if (!word_.empty()) return word_in(text);
        const auto quantities = quantities_in(text);
        return std::any_of(quantities.begin(), quantities.end(), [&](const Quantity& quantity) {
            return std::abs(quantity.value - number_) <= share_ * std::abs(number_);
        });
    }

    std::string text() const { return word_.empty() ? std::to_string(number_) : word_; }

  private:
    bool word_in(const std::string& text) const {
        const auto same = [](char a, char b) {
            // A text may be wrapped at any space.
            const auto plain = [](char c) { return c == '\n' ? ' ' : c; };
            return std::tolower(static_cast<unsigned char>(plain(a))) ==
                   std::tolower(static_cast<unsigned char>(plain(b)));
        };
        const auto alike = [](char a, char b) {
            return (is_digit(a) && is_digit(b)) || (is_letter(a) && is_letter(b));
        };
        for (auto from = text.begin();; ++from) {
            from = std::search(from, text.end(), word_.begin(), word_.end(), same);
            if (from == text.end()) return false;
            const auto to = from + static_cast<std::ptrdiff_t>(word_.size());
            const bool begins = from == text.begin() || !alike(from[-1], word_.front());
            const bool ends = to == text.end() || !(is_digit(word_.back()) && is_digit(*to));
            if (begins && ends) return true;
        }
    }

    std::string word_;
    double number_ = 0, share_ = 0;
};

/// Whether `text` states each of `facts`, in any order.
inline testing::AssertionResult names(const std::string& text, const std::vector<Fact>& facts) {
    for (const Fact& fact : facts) {
        if (!fact.stated_in(text)) return testing::AssertionFailure() << "no '" << fact.text() << "' in: " << text;
    }
    return testing::AssertionSuccess() << "named in: " << text;
}

/// Whether one of `texts` states each of `facts`.
inline testing::AssertionResult any_names(const std::vector<std::string>& texts, const std::vector<Fact>& facts) {
    std::string all;
    for (const std::string& text : texts) {
        if (names(text, facts)) return testing::AssertionSuccess() << "named in: " << text;
        all += text + "\n";
    }
    return testing::AssertionFailure() << "no text of these says it:\n" << all;
}

}  // namespace spectralpack::test
