#include "core/gltf/source/uri.h"

#include <array>
#include <cstdint>

namespace stretch::gltf {

namespace {

constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::string_view dataScheme = "data:";
constexpr std::uint8_t noDigit = 255;

std::array<std::uint8_t, 256> digitTable() {
  std::array<std::uint8_t, 256> table{};
  table.fill(noDigit);
  for (std::size_t i = 0; i < alphabet.size(); ++i) {
    table[static_cast<unsigned char>(alphabet[i])] = static_cast<std::uint8_t>(i);
  }
  return table;
}

std::string_view withoutPadding(std::string_view text) {
  for (int i = 0; i < 2 && text.ends_with('='); ++i) {
    text.remove_suffix(1);
  }
  return text;
}

std::optional<Bytes> decodeBase64(std::string_view text) {
  const std::array<std::uint8_t, 256> digits = digitTable();
  const std::string_view content = withoutPadding(text);
  if (content.size() % 4 == 1) {
    return std::nullopt;
  }
  Bytes bytes;
  bytes.reserve(content.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  unsigned bitCount = 0;
  for (const char letter : content) {
    const std::uint8_t digit = digits[static_cast<unsigned char>(letter)];
    if (digit == noDigit) {
      return std::nullopt;
    }
    bits = (bits << 6U | digit) & 0xFFFFFFU;
    bitCount += 6;
    if (bitCount >= 8) {
      bitCount -= 8;
      bytes.push_back(static_cast<std::uint8_t>(bits >> bitCount));
    }
  }
  return bytes;
}

int hexDigit(char letter) {
  if (letter >= '0' && letter <= '9') {
    return letter - '0';
  }
  const char lower = static_cast<char>(letter | 0x20);
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

// A '%' that starts no escape stands for itself: exporters write such names.
std::string percentDecoded(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool hasDigits =
        text[i] == '%' && i + 2 < text.size() && hexDigit(text[i + 1]) >= 0 && hexDigit(text[i + 2]) >= 0;
    if (hasDigits) {
      decoded.push_back(static_cast<char>(hexDigit(text[i + 1]) * 16 + hexDigit(text[i + 2])));
      i += 2;
    } else {
      decoded.push_back(text[i]);
    }
  }
  return decoded;
}

// RFC 3986: a scheme ends at a colon that no slash precedes. One letter is a drive, no scheme, and just as
// little relative.
bool hasScheme(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  return colon != std::string_view::npos && colon < uri.find('/');
}

} // namespace

bool isDataUri(std::string_view uri) {
  return uri.starts_with(dataScheme);
}

std::optional<DataUri> decodeDataUri(std::string_view uri) {
  constexpr std::string_view base64Mark = ";base64";
  const std::size_t comma = uri.find(',');
  if (!isDataUri(uri) || comma == std::string_view::npos) {
    return std::nullopt;
  }
  std::string_view header = uri.substr(dataScheme.size(), comma - dataScheme.size());
  if (!header.ends_with(base64Mark)) {
    const std::string text = percentDecoded(uri.substr(comma + 1));
    return DataUri{std::string(header), Bytes(text.begin(), text.end())};
  }
  header.remove_suffix(base64Mark.size());
  std::optional<Bytes> bytes = decodeBase64(uri.substr(comma + 1));
  if (!bytes) {
    return std::nullopt;
  }
  return DataUri{std::string(header), *std::move(bytes)};
}

std::string encodeBase64(std::span<const std::uint8_t> bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = static_cast<std::uint32_t>(bytes[i]) << 16U;
    bits |= i + 1 < bytes.size() ? static_cast<std::uint32_t>(bytes[i + 1]) << 8U : 0U;
    bits |= i + 2 < bytes.size() ? static_cast<std::uint32_t>(bytes[i + 2]) : 0U;
    text.push_back(alphabet[bits >> 18U & 63U]);
    text.push_back(alphabet[bits >> 12U & 63U]);
    text.push_back(i + 1 < bytes.size() ? alphabet[bits >> 6U & 63U] : '=');
    text.push_back(i + 2 < bytes.size() ? alphabet[bits & 63U] : '=');
  }
  return text;
}

std::optional<std::filesystem::path> relativePath(std::string_view uri) {
  const std::string decoded = hasScheme(uri) ? std::string() : percentDecoded(uri);
  if (decoded.empty() || decoded.find('\0') != std::string::npos) {
    return std::nullopt;
  }
  std::filesystem::path path(std::u8string(decoded.begin(), decoded.end()));
  if (path.has_root_path() || !path.has_filename()) {
    return std::nullopt;
  }
  return path;
}

std::string percentEncoded(std::string_view name) {
  constexpr std::string_view hexDigits = "0123456789ABCDEF";
  constexpr std::string_view unescaped =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~()!@+,";
  std::string encoded;
  for (const char letter : name) {
    const auto byte = static_cast<unsigned char>(letter);
    if (unescaped.find(letter) != std::string_view::npos) {
      encoded.push_back(letter);
    } else {
      encoded += {'%', hexDigits[byte >> 4U], hexDigits[byte & 15U]};
    }
  }
  return encoded;
}

bool escapesFolder(const std::filesystem::path& relative) {
  const std::filesystem::path normal = relative.lexically_normal();
  return normal.is_absolute() || (!normal.empty() && *normal.begin() == "..");
}

} // namespace stretch::gltf
