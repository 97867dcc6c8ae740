#include "tests/support/rig/families/whole_rigs.h"

#include <algorithm>

namespace stretch::test {

namespace {

using How = HelperJoint::How;

constexpr How inRow = How::inRow;
constexpr How handle = How::handle;

NamingScheme named(std::string title, std::string left, std::string right,
                   const std::vector<std::pair<std::string, std::string>>& names) {
  return {std::move(title), std::move(left), std::move(right), {names.begin(), names.end()}};
}

// clang-format off
const std::vector<WholeRig> rigs{
  {named("Unreal mannequin", "l", "r",
    {{"hips","pelvis"},{"spine0","spine_01"},{"spine1","spine_02"},{"spine2","spine_03"},{"spine3","spine_04"},{"spine4","spine_05"},{"neck0","neck_01"},{"neck1","neck_02"},{"head","head"},
     {"clavicle","clavicle_%"},{"upperArm","upperarm_%"},{"foreArm","lowerarm_%"},{"hand","hand_%"},{"thigh","thigh_%"},{"shin","calf_%"},{"foot","foot_%"},{"toe","ball_%"}}),
    {{"upperarm_twist_01_%","upperArm%","upperArm%","foreArm%",0.33},{"upperarm_twist_02_%","upperArm%","upperArm%","foreArm%",0.66},
     {"lowerarm_twist_02_%","foreArm%","foreArm%","hand%",0.33},{"lowerarm_twist_01_%","foreArm%","foreArm%","hand%",0.66},
     {"thigh_twist_01_%","thigh%","thigh%","shin%",0.33},{"thigh_twist_02_%","thigh%","thigh%","shin%",0.66},
     {"calf_twist_02_%","shin%","shin%","foot%",0.33},{"calf_twist_01_%","shin%","shin%","foot%",0.66},
     {"ik_foot_root","root","root","",0,{},handle},{"ik_foot_%","ik_foot_root","foot%","",0,{},handle},
     {"ik_hand_root","root","root","",0,{},handle},{"ik_hand_gun","ik_hand_root","hand.r","",0,{},handle},{"ik_hand_%","ik_hand_gun","hand%","",0,{},handle},
     {"interaction","root","root","",0,{},handle},{"center_of_mass","root","root","",0,{},handle}}},
  {named("MetaHuman", "l", "r",
    {{"hips","pelvis"},{"spine0","spine_01"},{"spine1","spine_02"},{"spine2","spine_03"},{"neck0","neck_01"},{"head","head"},
     {"clavicle","clavicle_%"},{"upperArm","upperarm_%"},{"foreArm","lowerarm_%"},{"hand","hand_%"},{"thigh","thigh_%"},{"shin","calf_%"},{"foot","foot_%"},{"toe","ball_%"}}),
    {{"upperarm_correctiveRoot_%","upperArm%","upperArm%"},{"upperarm_bck_%","upperarm_correctiveRoot_%","upperArm%","",0,{0,0,-0.05}},{"upperarm_fwd_%","upperarm_correctiveRoot_%","upperArm%","",0,{0,0,0.05}},
     {"upperarm_out_%","upperarm_correctiveRoot_%","upperArm%","",0,{0,0.05,0}},{"upperarm_twist_01_%","upperArm%","upperArm%","foreArm%",0.4},{"upperarm_tricep_%","upperarm_twist_01_%","upperArm%","foreArm%",0.4,{0,0,-0.04}},
     {"upperarm_bicep_%","upperarm_twist_01_%","upperArm%","foreArm%",0.4,{0,0,0.04}},{"lowerarm_correctiveRoot_%","foreArm%","foreArm%"},{"lowerarm_in_%","lowerarm_correctiveRoot_%","foreArm%","",0,{0,0,0.04}},
     {"lowerarm_out_%","lowerarm_correctiveRoot_%","foreArm%","",0,{0,0,-0.04}},{"wrist_inner_%","hand%","hand%","",0,{0,0,0.03}},{"thigh_correctiveRoot_%","thigh%","thigh%"},{"thigh_fwd_%","thigh_correctiveRoot_%","thigh%","",0,{0,0,0.08}},
     {"thigh_bck_%","thigh_correctiveRoot_%","thigh%","",0,{0,0,-0.09}},{"thigh_twist_01_%","thigh%","thigh%","shin%",0.4},{"calf_correctiveRoot_%","shin%","shin%"},{"calf_knee_%","calf_correctiveRoot_%","shin%","",0,{0,0,0.06}},
     {"calf_kneeBack_%","calf_correctiveRoot_%","shin%","",0,{0,0,-0.05}},{"ankle_bck_%","foot%","foot%","",0,{0,0,-0.05}},{"clavicle_pec_%","spine2","clavicle%","",0,{0,-0.08,0.1}},{"spine_04_latissimus_%","spine2","upperArm%","",0,{0,-0.15,-0.05}}}},
  {named("Character Creator", "L", "R",
    {{"root","CC_Base_BoneRoot"},{"hips","CC_Base_Hip"},{"spine0","CC_Base_Waist"},{"spine1","CC_Base_Spine01"},{"spine2","CC_Base_Spine02"},{"neck0","CC_Base_NeckTwist01"},{"neck1","CC_Base_NeckTwist02"},{"head","CC_Base_Head"},
     {"clavicle","CC_Base_%_Clavicle"},{"upperArm","CC_Base_%_Upperarm"},{"foreArm","CC_Base_%_Forearm"},{"hand","CC_Base_%_Hand"},{"thigh","CC_Base_%_Thigh"},{"shin","CC_Base_%_Calf"},{"foot","CC_Base_%_Foot"},{"toe","CC_Base_%_ToeBase"}}),
    {{"CC_Base_Pelvis","hips","hips","",0,{},inRow},{"CC_Base_%_UpperarmTwist01","upperArm%","upperArm%"},{"CC_Base_%_UpperarmTwist02","upperArm%","upperArm%","foreArm%",0.5},{"CC_Base_%_ElbowShareBone","foreArm%","foreArm%"},
     {"CC_Base_%_ForearmTwist01","foreArm%","foreArm%"},{"CC_Base_%_ForearmTwist02","foreArm%","foreArm%","hand%",0.5},{"CC_Base_%_ThighTwist01","thigh%","thigh%"},{"CC_Base_%_ThighTwist02","thigh%","thigh%","shin%",0.5},
     {"CC_Base_%_KneeShareBone","shin%","shin%"},{"CC_Base_%_CalfTwist01","shin%","shin%"},{"CC_Base_%_CalfTwist02","shin%","shin%","foot%",0.5},{"CC_Base_%_ToeBaseShareBone","foot%","toe%"},{"CC_Base_%_RibsTwist","spine2","spine2","",0,{0.06,0,0.05}},{"CC_Base_%_Breast","CC_Base_%_RibsTwist","spine2","",0,{0.08,0,0.12}},
     {"CC_Base_FacialBone","head","head"},{"CC_Base_JawRoot","CC_Base_FacialBone","head","",0,{0,0.02,0.04}},{"CC_Base_%_Eye","CC_Base_FacialBone","head","",0,{0.03,0.08,0.08}}}},
  {named("Daz Genesis 8", "l", "r",
    {{"hips","hip"},{"spine0","abdomenLower"},{"spine1","abdomenUpper"},{"spine2","chestLower"},{"spine3","chestUpper"},{"neck0","neckLower"},{"neck1","neckUpper"},{"head","head"},
     {"clavicle","%Collar"},{"upperArm","%ShldrBend"},{"foreArm","%ForearmBend"},{"hand","%Hand"},{"thigh","%ThighBend"},{"shin","%Shin"},{"foot","%Foot"},{"toe","%Toe"}}),
    {{"pelvis","hips","hips","",0,{0,-0.02,0}},{"%ShldrTwist","upperArm%","upperArm%","foreArm%",0.5,{},inRow},{"%ForearmTwist","foreArm%","foreArm%","hand%",0.5,{},inRow},{"%ThighTwist","thigh%","thigh%","shin%",0.5,{},inRow},
     {"%Metatarsals","foot%","foot%","toe%",0.4,{},inRow},{"%Pectoral","spine2","spine2","",0,{0.07,0.05,0.1}},{"lowerJaw","head","head","",0,{0,0.02,0.04}},{"%Eye","head","head","",0,{0.03,0.08,0.08}}}},
  {named("Daz Genesis 9", "l", "r",
    {{"hips","hip"},{"spine0","spine1"},{"spine1","spine2"},{"spine2","spine3"},{"spine3","spine4"},{"neck0","neck1"},{"neck1","neck2"},{"head","head"},
     {"clavicle","%_shoulder"},{"upperArm","%_upperarm"},{"foreArm","%_forearm"},{"hand","%_hand"},{"thigh","%_thigh"},{"shin","%_shin"},{"foot","%_foot"},{"toe","%_toes"}}),
    {{"pelvis","hips","hips","",0,{0,-0.02,0}},{"%_upperarmtwist1","upperArm%","upperArm%","foreArm%",0.2},{"%_upperarmtwist2","upperArm%","upperArm%","foreArm%",0.6},{"%_forearmtwist1","foreArm%","foreArm%","hand%",0.2},{"%_forearmtwist2","foreArm%","foreArm%","hand%",0.6},
     {"%_thightwist1","thigh%","thigh%","shin%",0.2},{"%_thightwist2","thigh%","thigh%","shin%",0.6},{"%_metatarsal","foot%","foot%","toe%",0.4,{},inRow},{"%_pectoral","spine3","spine3","",0,{0.07,0.05,0.1}}}},
  {named("Auto-Rig Pro", "l", "r",
    {{"hips","root.x"},{"spine0","spine_01.x"},{"spine1","spine_02.x"},{"spine2","spine_03.x"},{"neck0","neck.x"},{"head","head.x"},
     {"clavicle","shoulder.%"},{"upperArm","arm_stretch.%"},{"foreArm","forearm_stretch.%"},{"hand","hand.%"},{"thigh","thigh_stretch.%"},{"shin","leg_stretch.%"},{"foot","foot.%"},{"toe","toes_01.%"}}),
    {{"arm_twist.%","upperArm%","upperArm%","",0},{"c_arm_twist_offset.%","clavicle%","upperArm%","",0,{}},{"forearm_twist.%","foreArm%","foreArm%","hand%",0.6},{"thigh_twist.%","thigh%","thigh%","",0},{"leg_twist.%","shin%","shin%","foot%",0.6},
     {"c_subneck_1.x","spine2","neck0","",0,{0,-0.02,0}},{"breast_01.%","spine2","spine2","",0,{0.07,0.02,0.1}}}},
  {named("MakeHuman", "L", "R",
    {{"hips","root"},{"spine0","spine05"},{"spine1","spine04"},{"spine2","spine03"},{"spine3","spine02"},{"spine4","spine01"},{"neck0","neck01"},{"neck1","neck02"},{"head","head"},
     {"clavicle","clavicle.%"},{"upperArm","upperarm01.%"},{"foreArm","lowerarm01.%"},{"hand","wrist.%"},{"thigh","upperleg01.%"},{"shin","lowerleg01.%"},{"foot","foot.%"},{"toe","toe1-1.%"}}),
    {{"shoulder01.%","clavicle%","clavicle%","upperArm%",0.75,{},inRow},{"upperarm02.%","upperArm%","upperArm%","foreArm%",0.5,{},inRow},{"lowerarm02.%","foreArm%","foreArm%","hand%",0.5,{},inRow},{"upperleg02.%","thigh%","thigh%","shin%",0.5,{},inRow},{"lowerleg02.%","shin%","shin%","foot%",0.5,{},inRow},
     {"pelvis.%","hips","hips","thigh%",0.3,{},inRow},{"metacarpal1.%","hand%","hand%","",0,{0.03,0,0.02}},{"metacarpal2.%","hand%","hand%","",0,{0.03,0,0}},{"metacarpal3.%","hand%","hand%","",0,{0.03,0,-0.02}},{"toe2-1.%","foot%","toe%","",0,{0.02,0,0}},{"toe3-1.%","foot%","toe%","",0,{0.04,0,0}}}},
  {named("MMD", "左", "右",
    {{"root","全ての親"},{"hips","センター"},{"spine0","上半身"},{"spine1","上半身2"},{"neck0","首"},{"head","頭"},
     {"clavicle","%肩"},{"upperArm","%腕"},{"foreArm","%ひじ"},{"hand","%手首"},{"thigh","%足"},{"shin","%ひざ"},{"foot","%足首"},{"toe","%つま先"}}),
    {{"下半身","hips","hips","",0,{0,0.03,0},inRow},{"%腕捩","upperArm%","upperArm%","foreArm%",0.6,{},inRow},{"%手捩","foreArm%","foreArm%","hand%",0.6,{},inRow},{"%足ＩＫ","root","foot%","",0,{},handle},{"%つま先ＩＫ","%足ＩＫ","toe%","",0,{},handle},
     {"%目","head","head","",0,{0.03,0.08,0.08}},{"両目","head","head","",0,{0,0.2,0.05},handle},{"%胸","spine1","spine1","",0,{0.07,0.02,0.1}},{"%肩P","spine1","clavicle%","",0,{},handle},{"前髪","head","head","",0,{0,0.15,0.1}}}},
  {named("MMD with D bones", "左", "右",
    {{"root","全ての親"},{"hips","腰"},{"spine0","上半身"},{"spine1","上半身2"},{"neck0","首"},{"head","頭"},
     {"clavicle","%肩"},{"upperArm","%腕"},{"foreArm","%ひじ"},{"hand","%手首"},{"thigh","%足D"},{"shin","%ひざD"},{"foot","%足首D"},{"toe","%足先EX"}}),
    {{"%足","hips","thigh%","",0,{},handle},{"%ひざ","%足","shin%","",0,{},handle},{"%足首","%ひざ","foot%","",0,{},handle},{"%肩C","clavicle%","upperArm%","",0,{},inRow},{"%腕捩1","upperArm%","upperArm%","foreArm%",0.25},{"%腕捩2","upperArm%","upperArm%","foreArm%",0.5},{"%ひじ補助","upperArm%","foreArm%"},{"%ダミー","hand%","hand%","",0,{0.08,-0.02,0},handle}}},
  {named("3ds Max Biped, twists", "L", "R",
    {{"root","Bip001"},{"hips","Bip001 Pelvis"},{"spine0","Bip001 Spine"},{"spine1","Bip001 Spine1"},{"spine2","Bip001 Spine2"},{"neck0","Bip001 Neck"},{"head","Bip001 Head"},
     {"clavicle","Bip001 % Clavicle"},{"upperArm","Bip001 % UpperArm"},{"foreArm","Bip001 % Forearm"},{"hand","Bip001 % Hand"},{"thigh","Bip001 % Thigh"},{"shin","Bip001 % Calf"},{"foot","Bip001 % Foot"},{"toe","Bip001 % Toe0"}}),
    {{"Bip001 Footsteps","root","root","",0,{},handle},{"Bip001 %UpArmTwist","upperArm%","upperArm%"},{"Bip001 %UpArmTwist1","upperArm%","upperArm%","foreArm%",0.5},{"Bip001 % ForeTwist","foreArm%","foreArm%"},{"Bip001 % ForeTwist1","foreArm%","foreArm%","hand%",0.5},{"Bip001 %ThighTwist","thigh%","thigh%"},{"Bip001 %CalfTwist","shin%","shin%"},
     {"Bip001 % Toe0Nub","toe%","toe%","",0,{0,0,0.06},handle},{"Bip001 HeadNub","head","head","",0,{0,0.2,0},handle},{"Bip001 Prop1","hand.r","hand.r","",0,{0,0,0.05},handle},{"Bone_hair01","head","head","",0,{0,0.15,-0.1}},{"Bone_hair02","Bone_hair01","head","",0,{0,0,-0.15}}}},
  {named("CAT", "L", "R",
    {{"hips","CATRigHub001"},{"spine0","CATRigSpine1"},{"spine1","CATRigSpine2"},{"spine2","CATRigHub002"},{"neck0","CATRigSpine01"},{"head","CATRigHub003"},
     {"clavicle","CATRig%ArmCollarbone"},{"upperArm","CATRig%Arm1"},{"foreArm","CATRig%Arm2"},{"hand","CATRig%ArmPalm"},{"thigh","CATRig%Leg1"},{"shin","CATRig%Leg2"},{"foot","CATRig%LegAnkle"},{"toe","CATRig%LegDigit11"}}),
    {{"CATRig%ArmDigit11","hand%","hand%","",0,{0.05,0,0.03}},{"CATRig%ArmDigit21","hand%","hand%","",0,{0.08,0,0}},{"CATRig%ArmDigit31","hand%","hand%","",0,{0.08,0,-0.03}},{"CATRig%LegPlatform","root","foot%","",0,{0,-0.08,0},handle}}},
  {named("Source engine", "L", "R",
    {{"hips","ValveBiped.Bip01_Pelvis"},{"spine0","ValveBiped.Bip01_Spine"},{"spine1","ValveBiped.Bip01_Spine1"},{"spine2","ValveBiped.Bip01_Spine4"},{"neck0","ValveBiped.Bip01_Neck1"},{"head","ValveBiped.Bip01_Head1"},
     {"clavicle","ValveBiped.Bip01_%_Clavicle"},{"upperArm","ValveBiped.Bip01_%_UpperArm"},{"foreArm","ValveBiped.Bip01_%_Forearm"},{"hand","ValveBiped.Bip01_%_Hand"},{"thigh","ValveBiped.Bip01_%_Thigh"},{"shin","ValveBiped.Bip01_%_Calf"},{"foot","ValveBiped.Bip01_%_Foot"},{"toe","ValveBiped.Bip01_%_Toe0"}}),
    {{"ValveBiped.Bip01_%_Trapezius","clavicle%","clavicle%","upperArm%",0.5},{"ValveBiped.Bip01_%_Shoulder","upperArm%","upperArm%"},{"ValveBiped.Bip01_%_Bicep","upperArm%","upperArm%","foreArm%",0.5},{"ValveBiped.Bip01_%_Elbow","foreArm%","foreArm%"},{"ValveBiped.Bip01_%_Ulna","foreArm%","foreArm%","hand%",0.6},{"ValveBiped.Bip01_%_Wrist","foreArm%","hand%"},
     {"ValveBiped.Anim_Attachment_%H","hand%","hand%","",0,{0.05,0,0},handle},{"ValveBiped.forward","head","head","",0,{0,0,0.2},handle},{"ValveBiped.Bip01_%_Finger1","hand%","hand%","",0,{0.08,0,0}},{"ValveBiped.Bip01_%_Finger0","hand%","hand%","",0,{0.03,0,0.04}}}},
  {named("Skyrim", "L", "R",
    {{"root","NPC Root [Root]"},{"hips","NPC COM [COM ]"},{"spine0","NPC Spine [Spn0]"},{"spine1","NPC Spine1 [Spn1]"},{"spine2","NPC Spine2 [Spn2]"},{"neck0","NPC Neck [Neck]"},{"head","NPC Head [Head]"},
     {"clavicle","NPC % Clavicle [%Clv]"},{"upperArm","NPC % UpperArm [%Uar]"},{"foreArm","NPC % Forearm [%Lar]"},{"hand","NPC % Hand [%Hnd]"},{"thigh","NPC % Thigh [%Thg]"},{"shin","NPC % Calf [%Clf]"},{"foot","NPC % Foot [%ft ]"},{"toe","NPC % Toe0 [%Toe]"}}),
    {{"NPC Pelvis [Pelv]","hips","hips","",0,{0,-0.02,0}},{"NPC % UpperarmTwist1 [%Ut1]","upperArm%","upperArm%"},{"NPC % UpperarmTwist2 [%Ut2]","NPC % UpperarmTwist1 [%Ut1]","upperArm%","foreArm%",0.5},{"NPC % ForearmTwist1 [%Lt1]","foreArm%","foreArm%","hand%",0.3},{"WEAPON","hand.r","hand.r","",0,{0,0,0.06},handle},{"SHIELD","foreArm.l","hand.l","",0,{0,0,0.03},handle},{"QUIVER","spine2","spine2","",0,{0.1,0.1,-0.12},handle}}},
  {named("GTA", "L", "R",
    {{"root","SKEL_ROOT"},{"hips","SKEL_Pelvis"},{"spine0","SKEL_Spine_Root"},{"spine1","SKEL_Spine0"},{"spine2","SKEL_Spine1"},{"spine3","SKEL_Spine2"},{"neck0","SKEL_Neck_1"},{"head","SKEL_Head"},
     {"clavicle","SKEL_%_Clavicle"},{"upperArm","SKEL_%_UpperArm"},{"foreArm","SKEL_%_Forearm"},{"hand","SKEL_%_Hand"},{"thigh","SKEL_%_Thigh"},{"shin","SKEL_%_Calf"},{"foot","SKEL_%_Foot"},{"toe","SKEL_%_Toe0"}}),
    {{"RB_%_ArmRoll","upperArm%","upperArm%"},{"MH_%_Elbow","foreArm%","foreArm%"},{"RB_%_ForeArmRoll","foreArm%","foreArm%"},{"IK_%_Hand","hand%","hand%","",0,{},handle},{"PH_%_Hand","hand%","hand%","",0,{0.06,0,0},handle},{"RB_%_ThighRoll","thigh%","thigh%"},{"MH_%_Knee","shin%","shin%"},{"IK_%_Foot","foot%","foot%","",0,{},handle},{"PH_%_Foot","foot%","foot%","",0,{0,-0.05,0.05},handle},{"RB_Neck_1","neck0","neck0"},{"IK_Head","head","head","",0,{},handle}}},
  {named("Second Life", "Left", "Right",
    {{"hips","mPelvis"},{"spine0","mTorso"},{"spine1","mChest"},{"neck0","mNeck"},{"head","mHead"},
     {"clavicle","mCollar%"},{"upperArm","mShoulder%"},{"foreArm","mElbow%"},{"hand","mWrist%"},{"thigh","mHip%"},{"shin","mKnee%"},{"foot","mAnkle%"},{"toe","mFoot%"}}),
    {{"mSkull","head","head","",0,{0,0.15,0},handle},{"mEye%","head","head","",0,{0.03,0.08,0.08}},{"mToe%","toe%","toe%","",0,{0,0,0.08}}}},
  {named("Roblox R15", "Left", "Right",
    {{"root","HumanoidRootPart"},{"hips","LowerTorso"},{"spine0","UpperTorso"},{"head","Head"},{"upperArm","%UpperArm"},{"foreArm","%LowerArm"},{"hand","%Hand"},{"thigh","%UpperLeg"},{"shin","%LowerLeg"},{"foot","%Foot"}}), {}},
  {named("Poser", "l", "r",
    {{"root","BODY"},{"hips","hip"},{"spine0","abdomen"},{"spine1","chest"},{"neck0","neck"},{"head","head"},{"clavicle","%Collar"},{"upperArm","%Shldr"},{"foreArm","%ForeArm"},{"hand","%Hand"},{"thigh","%Thigh"},{"shin","%Shin"},{"foot","%Foot"},{"toe","%Toe"}}),
    {{"%Buttock","hips","hips","thigh%",0.5,{},inRow},{"%Thumb1","hand%","hand%","",0,{0.03,0,0.04}},{"%Index1","hand%","hand%","",0,{0.08,0,0.02}}}},
  {named("CMU mocap", "l", "r",
    {{"hips","root"},{"spine0","lowerback"},{"spine1","upperback"},{"spine2","thorax"},{"neck0","lowerneck"},{"neck1","upperneck"},{"head","head"},{"clavicle","%clavicle"},{"upperArm","%humerus"},{"foreArm","%radius"},{"hand","%wrist"},{"thigh","%femur"},{"shin","%tibia"},{"foot","%foot"},{"toe","%toes"}}),
    {{"%hipjoint","hips","hips","thigh%",0.1,{},inRow},{"%hand","hand%","hand%","",0,{0.05,0,0}},{"%thumb","hand%","hand%","",0,{0.03,0,0.04}}}},
  {named("Kinect", "Left", "Right",
    {{"hips","SpineBase"},{"spine0","SpineMid"},{"spine1","SpineShoulder"},{"neck0","Neck"},{"head","Head"},{"upperArm","Shoulder%"},{"foreArm","Elbow%"},{"hand","Wrist%"},{"thigh","Hip%"},{"shin","Knee%"},{"foot","Ankle%"},{"toe","Foot%"}}),
    {{"Hand%","hand%","hand%","",0,{0.06,0,0}},{"HandTip%","Hand%","hand%","",0,{0.12,0,0}},{"Thumb%","hand%","hand%","",0,{0.04,0,0.04}}}},
  {named("Xsens", "Left", "Right",
    {{"hips","Pelvis"},{"spine0","L5"},{"spine1","L3"},{"spine2","T12"},{"spine3","T8"},{"neck0","Neck"},{"head","Head"},{"clavicle","%Shoulder"},{"upperArm","%UpperArm"},{"foreArm","%Forearm"},{"hand","%Hand"},{"thigh","%UpperLeg"},{"shin","%LowerLeg"},{"foot","%Foot"},{"toe","%Toe"}}), {}},
  {named("Maya, bind joints", "L", "R",
    {{"root","global_jnt"},{"hips","C_pelvis_bind_jnt"},{"spine0","C_spine_01_bind_jnt"},{"spine1","C_spine_02_bind_jnt"},{"spine2","C_chest_bind_jnt"},{"neck0","C_neck_bind_jnt"},{"head","C_head_bind_jnt"},{"clavicle","%_clav_bind_jnt"},{"upperArm","%_upArm_bind_jnt"},{"foreArm","%_loArm_bind_jnt"},{"hand","%_hand_bind_jnt"},{"thigh","%_upLeg_bind_jnt"},{"shin","%_loLeg_bind_jnt"},{"foot","%_foot_bind_jnt"},{"toe","%_ball_bind_jnt"}}),
    {{"%_upArm_twist_01_bind_jnt","upperArm%","upperArm%","foreArm%",0.25},{"%_upArm_twist_02_bind_jnt","upperArm%","upperArm%","foreArm%",0.75},{"%_loArm_twist_01_bind_jnt","foreArm%","foreArm%","hand%",0.5},{"%_toe_end_jnt","toe%","toe%","",0,{0,0,0.06},handle}}},
  {named("mGear", "L", "R",
    {{"hips","spine_C0_0_jnt"},{"spine0","spine_C0_1_jnt"},{"spine1","spine_C0_2_jnt"},{"spine2","spine_C0_3_jnt"},{"neck0","neck_C0_0_jnt"},{"head","neck_C0_head_jnt"},{"clavicle","shoulder_%0_shoulder_jnt"},{"upperArm","arm_%0_0_jnt"},{"foreArm","arm_%0_3_jnt"},{"hand","arm_%0_end_jnt"},{"thigh","leg_%0_0_jnt"},{"shin","leg_%0_3_jnt"},{"foot","leg_%0_end_jnt"},{"toe","foot_%0_0_jnt"}}),
    {{"arm_%0_1_jnt","upperArm%","upperArm%","foreArm%",0.33,{},inRow},{"arm_%0_2_jnt","upperArm%","arm_%0_1_jnt","foreArm%",0.5,{},inRow},{"arm_%0_4_jnt","foreArm%","foreArm%","hand%",0.33,{},inRow},{"leg_%0_1_jnt","thigh%","thigh%","shin%",0.33,{},inRow},{"leg_%0_4_jnt","shin%","shin%","foot%",0.33,{},inRow}}},
  {named("Rigify, split", "L", "R",
    {{"root","root"},{"hips","DEF-spine"},{"spine0","DEF-spine.001"},{"spine1","DEF-spine.002"},{"spine2","DEF-spine.003"},{"neck0","DEF-spine.004"},{"neck1","DEF-spine.005"},{"head","DEF-spine.006"},{"clavicle","DEF-shoulder.%"},{"upperArm","DEF-upper_arm.%"},{"foreArm","DEF-forearm.%"},{"hand","DEF-hand.%"},{"thigh","DEF-thigh.%"},{"shin","DEF-shin.%"},{"foot","DEF-foot.%"},{"toe","DEF-toe.%"}}),
    {{"DEF-upper_arm.%.001","upperArm%","upperArm%","foreArm%",0.5,{},inRow},{"DEF-forearm.%.001","foreArm%","foreArm%","hand%",0.5,{},inRow},{"DEF-thigh.%.001","thigh%","thigh%","shin%",0.5,{},inRow},{"DEF-shin.%.001","shin%","shin%","foot%",0.5,{},inRow},{"DEF-pelvis.%","hips","hips","",0,{0.05,0.05,-0.04}},{"DEF-breast.%","spine2","spine2","",0,{0.07,0,0.1}}}},
  {named("Synty", "L", "R",
    {{"hips","Hips"},{"spine0","Spine_01"},{"spine1","Spine_02"},{"spine2","Spine_03"},{"neck0","Neck"},{"head","Head"},{"clavicle","Clavicle_%"},{"upperArm","Shoulder_%"},{"foreArm","Elbow_%"},{"hand","Hand_%"},{"thigh","UpperLeg_%"},{"shin","LowerLeg_%"},{"foot","Ankle_%"},{"toe","Ball_%"}}),
    {{"Toes_%","toe%","toe%","",0,{0,0,0.06}},{"Eyes","head","head","",0,{0,0.08,0.1}},{"Eyebrows","head","head","",0,{0,0.1,0.1}},{"Thumb_01","hand.l","hand.l","",0,{0.03,0,0.04}},{"Finger_01","hand.l","hand.l","",0,{0.08,0,0}},{"Thumb_01 1","hand.r","hand.r","",0,{-0.03,0,0.04}},{"Finger_01 1","hand.r","hand.r","",0,{-0.08,0,0}}}},
  {named("Quaternius universal", "L", "R",
    {{"hips","Hips"},{"spine0","Abdomen"},{"spine1","Torso"},{"neck0","Neck"},{"head","Head"},{"clavicle","Shoulder.%"},{"upperArm","UpperArm.%"},{"foreArm","LowerArm.%"},{"hand","Palm.%"},{"thigh","UpperLeg.%"},{"shin","LowerLeg.%"},{"foot","Foot.%"}}),
    {{"PoleTarget.%","root","shin%","",0,{0,0,0.5},handle},{"Middle1.%","hand%","hand%","",0,{0.06,0,0}},{"Thumb1.%","hand%","hand%","",0,{0.02,0,0.03}}}},
  {named("Dark game rig", "L", "R",
    {{"root","Master"},{"hips","Pelvis"},{"spine0","Spine"},{"spine1","Spine1"},{"spine2","Spine2"},{"neck0","Neck"},{"head","Head"},{"clavicle","%_Clavicle"},{"upperArm","%_UpperArm"},{"foreArm","%_Forearm"},{"hand","%_Hand"},{"thigh","%_Thigh"},{"shin","%_Calf"},{"foot","%_Foot"},{"toe","%_Toe0"}}),
    {{"%_UpArmTwist","upperArm%","upperArm%","foreArm%",0.5},{"%_ForeArmTwist","foreArm%","foreArm%","hand%",0.5},{"%_Shoulder","upperArm%","upperArm%","",0,{0,0.04,0}},{"%_Elbow","foreArm%","foreArm%","",0,{0,0,-0.03}},{"%_Knee","shin%","shin%","",0,{0,0,0.05}},{"%_Hip","hips","thigh%","",0,{0.04,0.02,0}},{"%_Weapon","hand%","hand%","",0,{0.05,0,0}}}},
  {named("Spanish", "Izq", "Der",
    {{"hips","Pelvis"},{"spine0","Columna_01"},{"spine1","Columna_02"},{"neck0","Cuello"},{"head","Cabeza"},{"clavicle","Hombro_%"},{"upperArm","Brazo_%"},{"foreArm","Codo_%"},{"hand","Muneca_%"},{"thigh","Pierna_%"},{"shin","Rodilla_%"},{"foot","Tobillo_%"},{"toe","Pie_%"}}), {}},
  {named("Portuguese", "E", "D",
    {{"hips","quadril"},{"spine0","coluna1"},{"spine1","coluna2"},{"neck0","pescoço"},{"head","cabeça"},{"clavicle","ombro.%"},{"upperArm","braço.%"},{"foreArm","antebraço.%"},{"hand","mão.%"},{"thigh","coxa.%"},{"shin","perna.%"},{"foot","pé.%"}}), {}},
  {named("German", "L", "R",
    {{"hips","Huefte"},{"spine0","Bauch"},{"spine1","Brust"},{"neck0","Hals"},{"head","Kopf"},{"clavicle","Schulter.%"},{"upperArm","Oberarm.%"},{"foreArm","Unterarm.%"},{"hand","Hand.%"},{"thigh","Oberschenkel.%"},{"shin","Unterschenkel.%"},{"foot","Fuss.%"}}), {}},
  {named("Bone of limbs", "L", "R",
    {{"hips","Bone_Hips"},{"spine0","Bone_Spine"},{"spine1","Bone_Chest"},{"neck0","Bone_Neck"},{"head","Bone_Head"},{"upperArm","Bone_Arm_Up_%"},{"foreArm","Bone_Arm_Low_%"},{"hand","Bone_Hand_%"},{"thigh","Bone_Leg_Up_%"},{"shin","Bone_Leg_Low_%"},{"foot","Bone_Foot_%"}}), {}},
  {named("Arms by number", "L", "R",
    {{"hips","pelvis"},{"spine0","spine1"},{"spine1","spine2"},{"neck0","neck"},{"head","head"},{"clavicle","arm1_%"},{"upperArm","arm2_%"},{"foreArm","arm3_%"},{"hand","arm4_%"},{"thigh","leg1_%"},{"shin","leg2_%"},{"foot","leg3_%"},{"toe","leg4_%"}}), {}},
  {named("Blender bones, sides by suffix", "L", "R",
    {{"hips","Bone"},{"spine0","Bone.001"},{"spine1","Bone.002"},{"neck0","Bone.003"},{"head","Bone.004"},{"clavicle","Bone.005.%"},{"upperArm","Bone.006.%"},{"foreArm","Bone.007.%"},{"hand","Bone.008.%"},{"thigh","Bone.009.%"},{"shin","Bone.010.%"},{"foot","Bone.011.%"},{"toe","Bone.012.%"}}),
    {{"Bone.013.%","hand%","hand%","",0,{0.08,0,0}},{"Bone.014.%","root","foot%","",0,{0,0,-0.2},handle},{"Bone.015.%","root","shin%","",0,{0,0,0.4},handle}}},
  {named("Perception Neuron", "Left", "Right",
    {{"hips","Robot_Hips"},{"spine0","Robot_Spine"},{"spine1","Robot_Spine1"},{"spine2","Robot_Spine2"},{"neck0","Robot_Neck"},{"head","Robot_Head"},{"clavicle","Robot_%Shoulder"},{"upperArm","Robot_%Arm"},{"foreArm","Robot_%ForeArm"},{"hand","Robot_%Hand"},{"thigh","Robot_%UpLeg"},{"shin","Robot_%Leg"},{"foot","Robot_%Foot"}}),
    {{"Robot_%InHandIndex","hand%","hand%","",0,{0.04,0,0.02}},{"Robot_%InHandMiddle","hand%","hand%","",0,{0.04,0,0}},{"Robot_%InHandRing","hand%","hand%","",0,{0.04,0,-0.02}}}},
  {named("Mixamo with rolls", "Left", "Right",
    {{"hips","mixamorig9:Hips"},{"spine0","mixamorig9:Spine"},{"spine1","mixamorig9:Spine1"},{"spine2","mixamorig9:Spine2"},{"neck0","mixamorig9:Neck"},{"head","mixamorig9:Head"},{"clavicle","mixamorig9:%Shoulder"},{"upperArm","mixamorig9:%Arm"},{"foreArm","mixamorig9:%ForeArm"},{"hand","mixamorig9:%Hand"},{"thigh","mixamorig9:%UpLeg"},{"shin","mixamorig9:%Leg"},{"foot","mixamorig9:%Foot"},{"toe","mixamorig9:%ToeBase"}}),
    {{"mixamorig9:%ArmRoll","upperArm%","upperArm%","foreArm%",0.5,{},inRow},{"mixamorig9:%ForeArmRoll","foreArm%","foreArm%","hand%",0.5,{},inRow},{"mixamorig9:%UpLegRoll","thigh%","thigh%","shin%",0.5,{},inRow},{"mixamorig9:%LegRoll","shin%","shin%","foot%",0.5,{},inRow}}},
  {named("Namespaces and meshes", "l", "r",
    {{"root","rig|root"},{"hips","rig|M_hips_SKN"},{"spine0","rig|M_spineA_SKN"},{"spine1","rig|M_spineB_SKN"},{"neck0","rig|M_neck_SKN"},{"head","rig|M_head_SKN"},{"clavicle","rig|%_clavicle_SKN"},{"upperArm","rig|%_armUpper_SKN"},{"foreArm","rig|%_armLower_SKN"},{"hand","rig|%_hand_SKN"},{"thigh","rig|%_legUpper_SKN"},{"shin","rig|%_legLower_SKN"},{"foot","rig|%_foot_SKN"},{"toe","rig|%_toe_SKN"}}),
    {{"rig|%_armUpperTwist_SKN","upperArm%","upperArm%","foreArm%",0.5},{"rig|%_cuff_SKN","foreArm%","foreArm%","hand%",0.8},{"rig|%_legSkirtA_SKN","hips","thigh%","",0,{0.05,-0.1,0.1}},{"rig|%_legSkirtB_SKN","rig|%_legSkirtA_SKN","thigh%","",0,{0.06,-0.3,0.14}}}},
};
// clang-format on

std::string withSide(const std::string& text, const std::string& side) {
  std::string done = text;
  for (std::size_t mark = 0; (mark = done.find('%', mark)) != std::string::npos; mark += side.size()) {
    done.replace(mark, 1, side);
  }
  return done;
}

bool isSided(const HelperJoint& helper) {
  return (helper.name + helper.parent + helper.from + helper.to).find('%') != std::string::npos;
}

const SyntheticJoint* find(const SyntheticBiped& body, const std::string& key) {
  const auto joint = std::ranges::find(body.joints, key, &SyntheticJoint::key);
  return joint == body.joints.end() ? nullptr : &*joint;
}

// `keys` stands for the side in keys of the body, `names` in names.
void addHelper(SyntheticBiped& body, const HelperJoint& helper, const std::string& keys,
               const std::string& names) {
  const auto keyOf = [&](const std::string& text) {
    const std::string key = withSide(text, keys);
    return find(body, key) != nullptr ? key : withSide(text, names);
  };
  const SyntheticJoint* const from = find(body, keyOf(helper.from));
  const SyntheticJoint* const to = helper.to.empty() ? nullptr : find(body, keyOf(helper.to));
  const SyntheticJoint* const parent = find(body, keyOf(helper.parent));
  if (from == nullptr || parent == nullptr || (to == nullptr && !helper.to.empty())) {
    return;
  }
  const Vec3 way = to == nullptr ? Vec3(0.0) : helper.share * (to->position - from->position);
  const Vec3 aside(keys == ".r" ? -helper.offset.x : helper.offset.x, helper.offset.y, helper.offset.z);
  const std::string name = withSide(helper.name, names);
  SyntheticJoint joint{name, parent->key, from->position + way + aside, true, helper.how != How::handle};
  if (helper.how == How::inRow && to != nullptr) {
    jointOf(body, to->key).parent = name;
  } else if (helper.how == How::inRow) {
    for (SyntheticJoint& child : body.joints) {
      child.parent = child.parent == parent->key && child.key.starts_with("thigh") ? name : child.parent;
    }
  }
  body.names[name] = name;
  body.joints.push_back(joint);
}

} // namespace

const std::vector<WholeRig>& wholeRigs() {
  return rigs;
}

BodyOptions optionsOf(const WholeRig& rig) {
  const auto has = [&](const std::string& key) { return rig.scheme.names.contains(key); };
  BodyOptions options;
  options.spineJoints = 0;
  while (has("spine" + std::to_string(options.spineJoints))) {
    ++options.spineJoints;
  }
  options.neckJoints = has("neck1") ? 2 : has("neck0") ? 1 : 0;
  options.clavicles = has("clavicle");
  options.toes = has("toe");
  options.fingers = false;
  return options;
}

void addHelpers(SyntheticBiped& body, const WholeRig& rig) {
  applyNames(body, rig.scheme);
  for (SyntheticJoint& joint : body.joints) { // some name a joint once for both sides
    std::string& name = body.names[joint.key];
    name = withSide(name, joint.key.ends_with(".r") ? rig.scheme.right : rig.scheme.left);
  }
  for (const HelperJoint& helper : rig.helpers) {
    if (isSided(helper)) {
      addHelper(body, helper, ".l", rig.scheme.left);
      addHelper(body, helper, ".r", rig.scheme.right);
    } else {
      addHelper(body, helper, "", "");
    }
  }
  if (body.names["root"].empty()) {
    body.names["root"] = "root";
  }
}

} // namespace stretch::test
