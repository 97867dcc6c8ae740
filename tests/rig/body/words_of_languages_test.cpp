// Words of the languages that rigs are named in: sides, parts of beasts, fins.
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "rig/body/evidence/name_evidence.h"
#include "rig/body/reading/extremities.h"

using namespace stretch::rig::body;

TEST_CASE("Left and right are read in every language, on their own and beside a joint's word") {
  const std::pair<Side, std::vector<std::string>> sidesOfLanguages[] = {
      {Side::left,
       {"left", "lft", "gauche", "links", "izquierda", "izquierdo", "sinistra", "sx", "esquerda", "esquerdo",
        "lewa", "lewy", "vanster", "левая", "左", "왼쪽"}},
      {Side::right,
       {"right", "rgt", "droite", "rechts", "derecha", "derecho", "destra", "dx", "direita", "direito",
        "prawa", "prawy", "hoger", "правая", "右", "오른쪽"}}};
  for (const auto& [side, words] : sidesOfLanguages) {
    for (const std::string& word : words) {
      CAPTURE(word);
      CHECK(readName(word).side == side);
      CHECK(readName("hand_" + word).side == side);
      const bool isLatin = static_cast<unsigned char>(word.front()) < 0x80;
      CHECK((!isLatin || readName("hand_" + word).key == readName("hand_left").key));
    }
  }
}

TEST_CASE("Parts of beasts are read in every language that they are named in") {
  const std::pair<PartWord, std::vector<std::string>> parts[] = {
      {PartWord::leg, {"hoof", "paw", "hock", "femur", "coxa", "patte", "jambe", "bein"}},
      {PartWord::arm, {"hand", "elbow", "bras"}},
      {PartWord::wing, {"wing", "feather", "aile", "ala", "fluegel", "Flügel"}},
      {PartWord::fin, {"fin", "flipper", "fluke", "pectoral", "dorsal", "nageoire"}},
      {PartWord::feeler, {"antenna", "antennae", "tentacle", "palp"}},
      {PartWord::claw, {"claw", "claws", "pincer", "pincers", "chela", "chelae"}},
      {PartWord::tail,
       {"tail", "queue", "schwanz", "cola", "coda", "cauda", "rabo", "хвост", "尾巴", "尻尾", "abdomen"}},
      {PartWord::head, {"head", "skull", "jaw", "tete", "cou", "kopf", "hals"}},
      {PartWord::ornament, {"horn", "horns", "antler", "antlers", "whisker", "mane", "saddle", "beak"}},
      {PartWord::front, {"front", "fore", "avant"}},
      {PartWord::back, {"back", "hind", "rear", "arriere", "hinten"}}};
  for (const auto& [part, words] : parts) {
    for (const std::string& word : words) {
      CAPTURE(word);
      CHECK(partWords(word + "_01") == std::set{part});
    }
  }
}

TEST_CASE("Fins are told by each of their words, and a limb's word beside one says that it is none") {
  for (const std::string word :
       {"fin", "fins", "flipper", "flippers", "fluke", "flukes", "pectoral", "nageoire"}) {
    CAPTURE(word);
    CHECK(readName(word + ".L").fin);
    CHECK_FALSE(readName(word + "_upperarm.L").fin);
  }
  CHECK_FALSE(readName("upperarm.L").fin);
}
