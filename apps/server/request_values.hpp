#pragma once
/// What requests say, taken with care: each throws Refusal (400) where it is not what is wanted.

#include <string>

#include "http/message.hpp"

namespace spectralpack::server {

Json body_of(const Request& request);

/// Empty where it is not said.
std::string text_in(const Json& body, const char* key);

/// A whole number from `least` to `most`.
int integer_in(const Json& body, const char* key, int least, int most);

/// Of the query; `otherwise` where it is not said.
std::size_t number_in(const Request& request, const char* key, std::size_t otherwise, std::size_t most);

/// Throws where it is no CopyName of openapi.json; it may say more.
void require_copy_name(const Json& copy);
/// Throws where these are no Changes of openapi.json, or more than `most`.
void require_changes(const Json& changes, std::size_t most);
void require_matrix(const Json& matrix);

}  // namespace spectralpack::server
