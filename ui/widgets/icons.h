#pragma once

/// Icons of the Font Awesome 4 font, as UTF-8 text.
namespace stretch::ui::icon {

inline constexpr const char* folderOpen = "\xEF\x81\xBC";
inline constexpr const char* folder = "\xEF\x81\xBB";
inline constexpr const char* file = "\xEF\x80\x96";
inline constexpr const char* save = "\xEF\x83\x87";
inline constexpr const char* undo = "\xEF\x83\xA2";
inline constexpr const char* redo = "\xEF\x80\x9E";
inline constexpr const char* play = "\xEF\x81\x8B";
inline constexpr const char* pause = "\xEF\x81\x8C";
inline constexpr const char* toStart = "\xEF\x81\x89";
inline constexpr const char* toEnd = "\xEF\x81\x90";
inline constexpr const char* previousKey = "\xEF\x81\x88";
inline constexpr const char* nextKey = "\xEF\x81\x91";
inline constexpr const char* stepBack = "\xEF\x84\x84";
inline constexpr const char* stepForward = "\xEF\x84\x85";
inline constexpr const char* loop = "\xEF\x81\xB9";
inline constexpr const char* visible = "\xEF\x81\xAE";
inline constexpr const char* hidden = "\xEF\x81\xB0";
inline constexpr const char* pin = "\xEF\x82\x8D";
inline constexpr const char* trash = "\xEF\x87\xB8";
inline constexpr const char* plus = "\xEF\x81\xA7";
inline constexpr const char* link = "\xEF\x83\x81";
inline constexpr const char* unlink = "\xEF\x84\xA7";
inline constexpr const char* check = "\xEF\x80\x8C";
inline constexpr const char* bolt = "\xEF\x83\xA7";
inline constexpr const char* magic = "\xEF\x83\x90";
inline constexpr const char* search = "\xEF\x80\x82";
inline constexpr const char* keyboard = "\xEF\x84\x9C";
inline constexpr const char* cog = "\xEF\x80\x93";
inline constexpr const char* help = "\xEF\x81\x99";
inline constexpr const char* warning = "\xEF\x81\xB1";
inline constexpr const char* info = "\xEF\x81\x9A";
inline constexpr const char* close = "\xEF\x80\x8D";
inline constexpr const char* chevronDown = "\xEF\x84\x87";
inline constexpr const char* chevronRight = "\xEF\x84\x85";
inline constexpr const char* up = "\xEF\x81\xA2";
inline constexpr const char* cube = "\xEF\x86\xB2";
inline constexpr const char* clock = "\xEF\x80\x97";
inline constexpr const char* controllers = "\xEF\x81\x87";
inline constexpr const char* skeleton = "\xEF\x83\xA8";
inline constexpr const char* graph = "\xEF\x88\x81";
inline constexpr const char* list = "\xEF\x80\xBA";
inline constexpr const char* refresh = "\xEF\x80\xA1";
inline constexpr const char* person = "\xEF\x86\x83";
inline constexpr const char* film = "\xEF\x80\x88";
inline constexpr const char* grid = "\xEF\x80\x8A";
inline constexpr const char* tag = "\xEF\x80\xAB";
inline constexpr const char* fire = "\xEF\x81\xAD";
inline constexpr const char* ghosts = "\xEF\x89\x8D";
inline constexpr const char* columns = "\xEF\x83\x9B";
inline constexpr const char* numbers = "\xEF\x85\xA2";
inline constexpr const char* pencil = "\xEF\x81\x80";
inline constexpr const char* mirror = "\xEF\x83\xAC";
inline constexpr const char* target = "\xEF\x81\x9B";
inline constexpr const char* reset = "\xEF\x80\x9E";
inline constexpr const char* circle = "\xEF\x84\x91";
inline constexpr const char* fit = "\xEF\x82\xB2";
inline constexpr const char* copy = "\xEF\x83\x85";
inline constexpr const char* paste = "\xEF\x83\xAA";
inline constexpr const char* wire = "\xEF\x86\xB3";
inline constexpr const char* sliders = "\xEF\x87\x9E";
inline constexpr const char* ellipsis = "\xEF\x85\x81";
inline constexpr const char* brush = "\xEF\x87\xBC";
inline constexpr const char* home = "\xEF\x80\x95";

/// Every icon above in one string: what the font atlas must hold.
inline constexpr const char* all =
    "\xEF\x81\xBC\xEF\x81\xBB\xEF\x80\x96\xEF\x83\x87\xEF\x83\xA2\xEF\x80\x9E\xEF\x81\x8B\xEF\x81\x8C\xEF\x81"
    "\x89\xEF\x81\x90"
    "\xEF\x81\x88\xEF\x81\x91\xEF\x84\x84\xEF\x84\x85\xEF\x81\xB9\xEF\x81\xAE\xEF\x81\xB0\xEF\x82\x8D\xEF\x87"
    "\xB8\xEF\x81\xA7"
    "\xEF\x83\x81\xEF\x84\xA7\xEF\x80\x8C\xEF\x83\xA7\xEF\x83\x90\xEF\x80\x82\xEF\x84\x9C\xEF\x80\x93\xEF\x81"
    "\x99\xEF\x81\xB1"
    "\xEF\x81\x9A\xEF\x80\x8D\xEF\x84\x87\xEF\x81\xA2\xEF\x86\xB2\xEF\x80\x97\xEF\x83\xA8\xEF\x88\x81\xEF\x80"
    "\xBA\xEF\x80\xA1"
    "\xEF\x86\x83\xEF\x80\x88\xEF\x80\x8A\xEF\x80\xAB\xEF\x81\xAD\xEF\x89\x8D\xEF\x83\x9B\xEF\x85\xA2\xEF\x81"
    "\x80\xEF\x83\xAC"
    "\xEF\x81\x9B\xEF\x84\x91\xEF\x82\xB2\xEF\x83\x85\xEF\x83\xAA\xEF\x86\xB3\xEF\x87\x9E\xEF\x80\x95\xEF\x85"
    "\x81\xEF\x81\x87\xEF\x87\xBC";

} // namespace stretch::ui::icon
