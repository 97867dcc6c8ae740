#include "rig/body/evidence/name_words.h"

#include <algorithm>
#include <array>

namespace stretch::rig::body {

namespace {

struct Entry {
  std::string_view word;
  Word meaning;
};

// Words of the schemes in use and of the languages that rigs are named in, folded as nameChunks() folds them.
// Words that are common in another sense ("el", "con", "sol") are left out.
// clang-format off
constexpr std::array entries = std::to_array<Entry>({
    {"left", Word::left}, {"l", Word::left}, {"lft", Word::left}, {"lf", Word::left},
    {"gauche", Word::left}, {"links", Word::left}, {"linke", Word::left}, {"izquierda", Word::left},
    {"izquierdo", Word::left}, {"izq", Word::left}, {"sinistra", Word::left}, {"sinistro", Word::left},
    {"sx", Word::left}, {"esquerda", Word::left}, {"esquerdo", Word::left}, {"esq", Word::left},
    {"lewy", Word::left}, {"lewa", Word::left}, {"vanster", Word::left}, {"лев", Word::left},
    {"левая", Word::left}, {"левый", Word::left}, {"левое", Word::left}, {"左", Word::left},
    {"왼쪽", Word::left},
    {"right", Word::right}, {"r", Word::right}, {"rgt", Word::right}, {"rt", Word::right},
    {"droite", Word::right}, {"droit", Word::right}, {"rechts", Word::right}, {"rechte", Word::right},
    {"derecha", Word::right}, {"derecho", Word::right}, {"der", Word::right}, {"destra", Word::right},
    {"destro", Word::right}, {"dx", Word::right}, {"direita", Word::right}, {"direito", Word::right},
    {"dir", Word::right}, {"prawy", Word::right}, {"prawa", Word::right}, {"hoger", Word::right},
    {"прав", Word::right}, {"правая", Word::right}, {"правый", Word::right}, {"правое", Word::right},
    {"右", Word::right}, {"오른쪽", Word::right},
    {"upper", Word::upper}, {"up", Word::upper}, {"upr", Word::upper}, {"uper", Word::upper},
    {"haut", Word::upper}, {"sup", Word::upper}, {"superior", Word::upper}, {"ober", Word::upper},
    {"верх", Word::upper}, {"верхняя", Word::upper},
    {"lower", Word::lower}, {"low", Word::lower}, {"lo", Word::lower}, {"lwr", Word::lower},
    {"lowr", Word::lower}, {"bas", Word::lower}, {"inf", Word::lower}, {"inferior", Word::lower},
    {"unter", Word::lower}, {"нижняя", Word::lower},
    {"fore", Word::fore}, {"front", Word::fore}, {"avant", Word::fore},
    {"arm", Word::arm}, {"bras", Word::arm}, {"brazo", Word::arm}, {"braccio", Word::arm},
    {"braco", Word::arm}, {"腕", Word::arm}, {"うで", Word::arm}, {"팔", Word::arm},
    {"leg", Word::leg}, {"jambe", Word::leg}, {"pierna", Word::leg}, {"gamba", Word::leg},
    {"perna", Word::leg}, {"bein", Word::leg}, {"noga", Word::leg}, {"been", Word::leg},
    {"нога", Word::leg}, {"足", Word::leg}, {"脚", Word::leg}, {"腿", Word::leg}, {"다리", Word::leg},
    {"ustkol", Word::upperArm}, {"altkol", Word::foreArm}, {"uyluk", Word::thigh}, {"baldir", Word::shin},
    {"gogus", Word::chest}, {"kafa", Word::head}, {"obojczyk", Word::clavicle}, {"torace", Word::chest}, {"canela", Word::shin},
    {"upperarm", Word::upperArm}, {"uparm", Word::upperArm}, {"upperarms", Word::upperArm},
    {"uarm", Word::upperArm}, {"humerus", Word::upperArm}, {"biceps", Word::upperArm},
    {"bicep", Word::upperArm}, {"oberarm", Word::upperArm}, {"bovenarm", Word::upperArm},
    {"ramie", Word::upperArm}, {"плечо", Word::upperArm}, {"上腕", Word::upperArm}, {"上臂", Word::upperArm},
    {"大臂", Word::upperArm}, {"위팔", Word::upperArm},
    {"forearm", Word::foreArm}, {"lowerarm", Word::foreArm}, {"lowarm", Word::foreArm},
    {"loarm", Word::foreArm}, {"ulna", Word::foreArm}, {"radius", Word::foreArm},
    {"unterarm", Word::foreArm}, {"onderarm", Word::foreArm}, {"avantbras", Word::foreArm},
    {"antebrazo", Word::foreArm}, {"avambraccio", Word::foreArm}, {"antebraco", Word::foreArm},
    {"przedramie", Word::foreArm}, {"предплечье", Word::foreArm}, {"前腕", Word::foreArm},
    {"前臂", Word::foreArm}, {"小臂", Word::foreArm}, {"下腕", Word::foreArm}, {"아래팔", Word::foreArm},
    {"elbow", Word::elbow}, {"coude", Word::elbow}, {"codo", Word::elbow}, {"gomito", Word::elbow},
    {"cotovelo", Word::elbow}, {"ellbogen", Word::elbow}, {"ellenbogen", Word::elbow},
    {"elleboog", Word::elbow}, {"lokiec", Word::elbow}, {"dirsek", Word::elbow}, {"локоть", Word::elbow},
    {"ひじ", Word::elbow}, {"肘", Word::elbow}, {"팔꿈치", Word::elbow},
    {"wrist", Word::wrist}, {"poignet", Word::wrist}, {"muneca", Word::wrist}, {"polso", Word::wrist},
    {"pulso", Word::wrist}, {"handgelenk", Word::wrist}, {"pols", Word::wrist},
    {"nadgarstek", Word::wrist}, {"bilek", Word::wrist}, {"запястье", Word::wrist}, {"手首", Word::wrist},
    {"手腕", Word::wrist}, {"손목", Word::wrist},
    {"hand", Word::hand}, {"main", Word::hand}, {"mano", Word::hand}, {"mao", Word::hand},
    {"dlon", Word::hand}, {"кисть", Word::hand}, {"рука", Word::hand}, {"手", Word::hand},
    {"손", Word::hand},
    {"palm", Word::palm}, {"paume", Word::palm}, {"handpalm", Word::palm}, {"metacarpus", Word::palm},
    {"fingerbase", Word::palm}, {"handbase", Word::palm}, {"paw", Word::palm},
    {"finger", Word::finger}, {"fingers", Word::finger}, {"thumb", Word::finger}, {"index", Word::finger},
    {"indexfinger", Word::finger}, {"middle", Word::finger}, {"mid", Word::finger}, {"ring", Word::finger},
    {"pinky", Word::finger}, {"pinkie", Word::finger}, {"little", Word::finger},
    {"littlefinger", Word::finger}, {"metacarpal", Word::finger}, {"carpal", Word::finger},
    {"phalange", Word::finger}, {"phalanx", Word::finger}, {"doigt", Word::finger},
    {"pouce", Word::finger}, {"majeur", Word::finger}, {"annulaire", Word::finger},
    {"auriculaire", Word::finger}, {"dedo", Word::finger}, {"pulgar", Word::finger},
    {"indice", Word::finger}, {"medio", Word::finger}, {"anular", Word::finger}, {"menique", Word::finger},
    {"dito", Word::finger}, {"pollice", Word::finger}, {"daumen", Word::finger},
    {"zeigefinger", Word::finger}, {"mittelfinger", Word::finger}, {"ringfinger", Word::finger},
    {"vinger", Word::finger}, {"duim", Word::finger}, {"палец", Word::finger}, {"knuckle", Word::finger},
    {"指", Word::finger}, {"親指", Word::finger}, {"人指", Word::finger}, {"人差指", Word::finger},
    {"中指", Word::finger}, {"薬指", Word::finger}, {"小指", Word::finger}, {"손가락", Word::finger},
    {"clavicle", Word::clavicle}, {"clav", Word::clavicle}, {"clavicula", Word::clavicle},
    {"clavicola", Word::clavicle}, {"clavicule", Word::clavicle}, {"collar", Word::clavicle},
    {"collarbone", Word::clavicle}, {"scapula", Word::clavicle}, {"scap", Word::clavicle},
    {"omoplate", Word::clavicle}, {"schlusselbein", Word::clavicle}, {"schluesselbein", Word::clavicle},
    {"ключица", Word::clavicle}, {"鎖骨", Word::clavicle}, {"锁骨", Word::clavicle}, {"쇄골", Word::clavicle},
    {"shoulder", Word::shoulder}, {"shldr", Word::shoulder}, {"shoulders", Word::shoulder},
    {"epaule", Word::shoulder}, {"hombro", Word::shoulder}, {"spalla", Word::shoulder},
    {"ombro", Word::shoulder}, {"schulter", Word::shoulder}, {"schouder", Word::shoulder},
    {"omuz", Word::shoulder}, {"肩", Word::shoulder}, {"어깨", Word::shoulder},
    {"thigh", Word::thigh}, {"upperleg", Word::thigh}, {"upleg", Word::thigh}, {"uleg", Word::thigh},
    {"femur", Word::thigh}, {"cuisse", Word::thigh}, {"muslo", Word::thigh}, {"coscia", Word::thigh},
    {"coxa", Word::thigh}, {"oberschenkel", Word::thigh}, {"bovenbeen", Word::thigh}, {"udo", Word::thigh},
    {"бедро", Word::thigh}, {"大腿", Word::thigh}, {"太もも", Word::thigh}, {"허벅지", Word::thigh},
    {"hip", Word::hip}, {"hanche", Word::hip}, {"cadera", Word::hip}, {"anca", Word::hip},
    {"huefte", Word::hip}, {"hufte", Word::hip}, {"heup", Word::hip}, {"quadril", Word::hip},
    {"kalca", Word::hip}, {"biodro", Word::hip},
    {"hips", Word::hips}, {"pelvis", Word::hips}, {"pelv", Word::hips}, {"bassin", Word::hips},
    {"bacino", Word::hips}, {"bacia", Word::hips}, {"becken", Word::hips}, {"bekken", Word::hips},
    {"miednica", Word::hips}, {"hipbone", Word::hips}, {"lowerbody", Word::hips},
    {"lowertorso", Word::hips}, {"buttocks", Word::hips}, {"butt", Word::hips}, {"таз", Word::hips},
    {"下半身", Word::hips}, {"骨盆", Word::hips}, {"腰", Word::hips}, {"골반", Word::hips},
    {"knee", Word::knee}, {"genou", Word::knee}, {"rodilla", Word::knee}, {"ginocchio", Word::knee},
    {"joelho", Word::knee}, {"knie", Word::knee}, {"kolano", Word::knee}, {"diz", Word::knee},
    {"колено", Word::knee}, {"ひざ", Word::knee}, {"膝", Word::knee}, {"무릎", Word::knee},
    {"shin", Word::shin}, {"calf", Word::shin}, {"shank", Word::shin}, {"lowerleg", Word::shin},
    {"lowleg", Word::shin}, {"loleg", Word::shin}, {"crus", Word::shin}, {"tibia", Word::shin},
    {"fibula", Word::shin}, {"mollet", Word::shin}, {"pantorrilla", Word::shin}, {"polpaccio", Word::shin},
    {"panturrilha", Word::shin}, {"unterschenkel", Word::shin}, {"onderbeen", Word::shin},
    {"kuit", Word::shin}, {"lydka", Word::shin}, {"голень", Word::shin}, {"小腿", Word::shin},
    {"すね", Word::shin}, {"종아리", Word::shin},
    {"ankle", Word::ankle}, {"cheville", Word::ankle}, {"tobillo", Word::ankle}, {"caviglia", Word::ankle},
    {"tornozelo", Word::ankle}, {"knochel", Word::ankle}, {"knoechel", Word::ankle},
    {"enkel", Word::ankle}, {"kostka", Word::ankle}, {"лодыжка", Word::ankle}, {"щиколотка", Word::ankle},
    {"足首", Word::ankle}, {"脚踝", Word::ankle}, {"발목", Word::ankle},
    {"foot", Word::foot}, {"feet", Word::foot}, {"pied", Word::foot}, {"pie", Word::foot},
    {"piede", Word::foot}, {"pe", Word::foot}, {"fuss", Word::foot}, {"fuess", Word::foot},
    {"voet", Word::foot}, {"stopa", Word::foot}, {"ayak", Word::foot}, {"стопа", Word::foot},
    {"脚掌", Word::foot}, {"발", Word::foot},
    {"toe", Word::toe}, {"toes", Word::toe}, {"toebase", Word::toe}, {"ball", Word::toe},
    {"ballfoot", Word::toe}, {"orteil", Word::toe}, {"orteils", Word::toe}, {"zehe", Word::toe},
    {"zehen", Word::toe}, {"teen", Word::toe}, {"tenen", Word::toe}, {"palec", Word::toe},
    {"dita", Word::toe}, {"つま先", Word::toe}, {"足先", Word::toe}, {"脚趾", Word::toe}, {"носок", Word::toe},
    {"spine", Word::spine}, {"spin", Word::spine}, {"backbone", Word::spine}, {"vertebra", Word::spine},
    {"vertebrae", Word::spine}, {"lumbar", Word::spine}, {"lombaires", Word::spine},
    {"thoracic", Word::spine}, {"colonne", Word::spine}, {"dos", Word::spine}, {"columna", Word::spine},
    {"colonna", Word::spine}, {"coluna", Word::spine}, {"wirbelsaule", Word::spine},
    {"wirbelsaeule", Word::spine}, {"wirbel", Word::spine}, {"ruggengraat", Word::spine},
    {"rug", Word::spine}, {"kregoslup", Word::spine}, {"omurga", Word::spine},
    {"позвоночник", Word::spine}, {"спина", Word::spine}, {"脊椎", Word::spine}, {"脊柱", Word::spine},
    {"上半身", Word::spine}, {"척추", Word::spine},
    {"chest", Word::chest}, {"thorax", Word::chest}, {"ribs", Word::chest}, {"ribcage", Word::chest},
    {"rib", Word::chest}, {"breastbone", Word::chest}, {"sternum", Word::chest},
    {"upperchest", Word::chest}, {"uppertorso", Word::chest}, {"poitrine", Word::chest},
    {"plexus", Word::chest}, {"pecho", Word::chest}, {"petto", Word::chest}, {"peito", Word::chest},
    {"brust", Word::chest}, {"brustkorb", Word::chest}, {"borst", Word::chest}, {"klatka", Word::chest},
    {"грудь", Word::chest}, {"胸", Word::chest}, {"가슴", Word::chest},
    {"torso", Word::torso}, {"torse", Word::torso}, {"trunk", Word::torso}, {"tronco", Word::torso},
    {"tronc", Word::torso}, {"abdomen", Word::torso}, {"abdom", Word::torso}, {"abs", Word::torso},
    {"belly", Word::torso}, {"stomach", Word::torso}, {"tummy", Word::torso}, {"ventre", Word::torso},
    {"bauch", Word::torso}, {"rumpf", Word::torso}, {"upperbody", Word::torso}, {"pancia", Word::torso},
    {"addome", Word::torso}, {"tors", Word::torso}, {"туловище", Word::torso}, {"живот", Word::torso},
    {"waist", Word::waist}, {"taille", Word::waist}, {"cintura", Word::waist}, {"vita", Word::waist},
    {"пояс", Word::waist},
    {"body", Word::body}, {"corps", Word::body}, {"cuerpo", Word::body}, {"corpo", Word::body},
    {"korper", Word::body}, {"koerper", Word::body}, {"тело", Word::body},
    {"neck", Word::neck}, {"cou", Word::neck}, {"cuello", Word::neck}, {"collo", Word::neck},
    {"pescoco", Word::neck}, {"hals", Word::neck}, {"nacken", Word::neck}, {"nek", Word::neck},
    {"szyja", Word::neck}, {"boyun", Word::neck}, {"шея", Word::neck}, {"首", Word::neck},
    {"脖子", Word::neck}, {"목", Word::neck},
    {"head", Word::head}, {"tete", Word::head}, {"cabeza", Word::head}, {"testa", Word::head},
    {"cabeca", Word::head}, {"kopf", Word::head}, {"hoofd", Word::head}, {"glowa", Word::head},
    {"skull", Word::head}, {"crane", Word::head}, {"голова", Word::head}, {"頭", Word::head},
    {"头", Word::head}, {"머리", Word::head},
    {"cervical", Word::neck}, {"cervicale", Word::neck},
    {"twist", Word::twist}, {"twst", Word::twist}, {"roll", Word::twist}, {"rolling", Word::twist},
    {"split", Word::twist}, {"segment", Word::twist}, {"bendy", Word::twist}, {"bbone", Word::twist},
    {"deltoid", Word::twist}, {"correctiveroot", Word::twist}, {"corrective", Word::twist},
    {"correct", Word::twist}, {"fix", Word::twist}, {"ribbon", Word::twist}, {"muscle", Word::twist},
    {"捩", Word::twist},
    {"ik", Word::control}, {"fk", Word::control}, {"iktarget", Word::control}, {"pole", Word::control},
    {"poletarget", Word::control}, {"polevector", Word::control}, {"target", Word::control},
    {"tgt", Word::control}, {"ctrl", Word::control}, {"ctl", Word::control}, {"cntrl", Word::control},
    {"control", Word::control}, {"controls", Word::control}, {"controller", Word::control},
    {"mch", Word::control}, {"org", Word::control}, {"wgt", Word::control}, {"helper", Word::control},
    {"aux", Word::control}, {"tweak", Word::control}, {"effector", Word::control}, {"goal", Word::control},
    {"locator", Word::control}, {"loc", Word::control}, {"handle", Word::control},
    {"driver", Word::control}, {"heelik", Word::control}, {"gizmo", Word::control},
    {"placer", Word::control}, {"親", Word::control}, {"キャンセル", Word::control},
    {"end", Word::end}, {"leaf", Word::end}, {"nub", Word::end}, {"tip", Word::end},
    {"endsite", Word::end}, {"site", Word::end}, {"null", Word::end}, {"topend", Word::end},
    {"effectorend", Word::end},
    {"slot", Word::accessory}, {"prop", Word::accessory}, {"props", Word::accessory},
    {"weapon", Word::accessory}, {"weap", Word::accessory}, {"gun", Word::accessory},
    {"sword", Word::accessory}, {"shield", Word::accessory}, {"arme", Word::accessory},
    {"arma", Word::accessory}, {"waffe", Word::accessory}, {"item", Word::accessory},
    {"attach", Word::accessory}, {"attachment", Word::accessory}, {"attachpoint", Word::accessory},
    {"socket", Word::accessory}, {"holder", Word::accessory}, {"mount", Word::accessory},
    {"cape", Word::accessory}, {"cloak", Word::accessory}, {"skirt", Word::accessory},
    {"cloth", Word::accessory}, {"clothes", Word::accessory}, {"coat", Word::accessory},
    {"hair", Word::accessory}, {"hairs", Word::accessory}, {"bang", Word::accessory},
    {"bangs", Word::accessory}, {"ponytail", Word::accessory}, {"braid", Word::accessory},
    {"tail", Word::accessory}, {"ear", Word::accessory}, {"ears", Word::accessory},
    {"eye", Word::face}, {"eyes", Word::face}, {"eyelid", Word::face},
    {"eyebrow", Word::face}, {"brow", Word::face}, {"lid", Word::face},
    {"jaw", Word::face}, {"machoire", Word::face}, {"mouth", Word::face},
    {"lip", Word::face}, {"lips", Word::face}, {"tongue", Word::face},
    {"teeth", Word::face}, {"tooth", Word::face}, {"nose", Word::face},
    {"cheek", Word::face}, {"chin", Word::face}, {"face", Word::face},
    {"facial", Word::face}, {"beard", Word::face}, {"breast", Word::accessory},
    {"breasts", Word::accessory}, {"boob", Word::accessory}, {"bust", Word::accessory},
    {"nipple", Word::accessory}, {"pec", Word::accessory}, {"pecs", Word::accessory},
    {"wing", Word::accessory}, {"wings", Word::accessory}, {"feather", Word::accessory},
    {"antenna", Word::accessory}, {"hat", Word::accessory}, {"helmet", Word::accessory},
    {"glasses", Word::accessory}, {"backpack", Word::accessory}, {"bag", Word::accessory},
    {"belt", Word::accessory}, {"pouch", Word::accessory}, {"strap", Word::accessory},
    {"scarf", Word::accessory}, {"tassel", Word::accessory}, {"accessory", Word::accessory},
    {"acc", Word::accessory}, {"dynamic", Word::accessory}, {"jiggle", Word::accessory},
    {"physics", Word::accessory}, {"camera", Word::accessory}, {"cam", Word::accessory},
    {"armor", Word::accessory}, {"armour", Word::accessory}, {"pauldron", Word::accessory},
    {"pad", Word::accessory}, {"kneepad", Word::accessory}, {"elbowpad", Word::accessory},
    {"shoulderpad", Word::accessory}, {"patella", Word::accessory},
    {"heel", Word::accessory}, {"sleeve", Word::accessory},
    {"pocket", Word::accessory}, {"dress", Word::accessory}, {"collider", Word::accessory},
    {"robe", Word::accessory}, {"gown", Word::accessory}, {"hem", Word::accessory},
    {"glute", Word::accessory}, {"gluteus", Word::accessory}, {"penis", Word::accessory},
    {"genital", Word::accessory}, {"holster", Word::accessory}, {"quiver", Word::accessory},
    {"scabbard", Word::accessory}, {"sheath", Word::accessory}, {"bow", Word::accessory},
    {"arrow", Word::accessory}, {"staff", Word::accessory}, {"髪", Word::accessory}, {"目", Word::face},
    {"乳", Word::accessory}, {"スカート", Word::accessory}, {"耳", Word::accessory}, {"舌", Word::face},
    {"尻尾", Word::accessory}, {"眉", Word::face}, {"袖", Word::accessory},
    {"fin", Word::fin}, {"fins", Word::fin}, {"flipper", Word::fin}, {"flippers", Word::fin},
    {"fluke", Word::fin}, {"flukes", Word::fin}, {"pectoral", Word::fin}, {"nageoire", Word::fin},
    {"jnt", Word::noise}, {"joint", Word::noise}, {"joints", Word::noise}, {"bone", Word::noise},
    {"bones", Word::noise}, {"bn", Word::noise}, {"skeleton", Word::noise}, {"skel", Word::noise},
    {"bip", Word::noise}, {"biped", Word::noise}, {"def", Word::noise}, {"deform", Word::noise},
    {"drv", Word::noise}, {"bind", Word::noise}, {"skin", Word::noise}, {"sk", Word::noise},
    {"jt", Word::noise}, {"armature", Word::noise}, {"rig", Word::noise}, {"char", Word::noise},
    {"character", Word::noise}, {"mixamorig", Word::noise}, {"valve", Word::noise}, {"cc", Word::noise},
    {"base", Word::noise}, {"root", Word::noise}, {"bend", Word::noise}, {"share", Word::noise},
    {"mesh", Word::noise}, {"geo", Word::noise}, {"grp", Word::noise}, {"group", Word::noise},
    {"node", Word::noise}, {"object", Word::noise}, {"back", Word::noise},
    {"hind", Word::noise}, {"rear", Word::noise},
});
// clang-format on

constexpr auto sortedEntries = [] {
  auto sorted = entries;
  std::ranges::sort(sorted, {}, &Entry::word);
  return sorted;
}();

constexpr std::size_t longestSegmented = 40;

bool isSideLetter(std::string_view word) {
  return word == "l" || word == "r";
}

// Whether `piece` of a run-together chunk counts as a word: side letters only at its ends, two letters only
// for sides and for what schemes really glue ("up", "lo", "ik").
bool isSegment(std::string_view text, std::size_t from, std::size_t length) {
  const std::string_view piece = text.substr(from, length);
  if (isSideLetter(piece)) {
    return text.size() > 3 && (from == 0 || from + length == text.size());
  }
  return length > 2 || piece == "up" || piece == "lo" || piece == "ik" || piece == "fk";
}

// Those of a run-together text; none where it cannot be covered.
std::vector<Word> segment(std::string_view text) {
  std::vector<Word> words;
  for (const std::string_view piece :
       cutIntoWords(text, [](std::string_view word) { return lookUpWord(word).has_value(); })) {
    words.push_back(*lookUpWord(piece));
  }
  return words;
}

bool startsIdeograph(std::string_view text) {
  return static_cast<unsigned char>(text.front()) >= 0xE3;
}

// Ideographs are written without spaces: the longest known word at every place.
std::vector<Word> greedyWords(std::string_view text) {
  std::vector<Word> words;
  while (!text.empty()) {
    std::size_t length = std::min(text.size(), longestSegmented);
    std::optional<Word> word;
    while (length > 0 && !(word = lookUpWord(text.substr(0, length)))) {
      --length;
    }
    if (word) {
      words.push_back(*word);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return words;
}

} // namespace

std::optional<Word> lookUpWord(std::string_view word) {
  const auto* const found = std::ranges::lower_bound(sortedEntries, word, {}, &Entry::word);
  return found != sortedEntries.end() && found->word == word ? std::optional(found->meaning) : std::nullopt;
}

std::vector<std::string_view> cutIntoWords(std::string_view text, const KnowsWord& knows) {
  if (text.empty() || text.size() > longestSegmented) {
    return {};
  }
  std::vector<std::optional<std::vector<std::string_view>>> best(text.size() + 1);
  best[0] = std::vector<std::string_view>{};
  for (std::size_t from = 0; from < text.size(); ++from) {
    if (!best[from]) {
      continue;
    }
    for (std::size_t length = 1; from + length <= text.size(); ++length) {
      const std::string_view piece = text.substr(from, length);
      const auto& known = best[from + length];
      if (!isSegment(text, from, length) || (known && known->size() <= best[from]->size() + 1) ||
          !knows(piece)) {
        continue;
      }
      std::vector<std::string_view> words = *best[from];
      words.push_back(piece);
      best[from + length] = std::move(words);
    }
  }
  return best[text.size()].value_or(std::vector<std::string_view>{});
}

std::vector<Word> chunkWords(const NameChunk& chunk) {
  if (chunk.whole.empty()) {
    return {};
  }
  if (startsIdeograph(chunk.whole)) {
    return greedyWords(chunk.whole);
  }
  if (const std::optional<Word> word = lookUpWord(chunk.whole)) {
    return {*word};
  }
  std::vector<Word> words = segment(chunk.whole);
  if (!words.empty()) {
    return words;
  }
  for (const std::string& part : chunk.parts) {
    const std::optional<Word> word = lookUpWord(part);
    const std::vector<Word> pieces = word ? std::vector{*word} : segment(part);
    words.insert(words.end(), pieces.begin(), pieces.end());
  }
  return words;
}

} // namespace stretch::rig::body
